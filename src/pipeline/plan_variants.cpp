#include "pipeline/plan_variants.h"

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <memory>
#include <set>
#include <sstream>
#include <string>
#include <utility>
#include <variant>

#include "nacre/base/error.h"
#include "nacre/lut/planned_lut.h"
#include "nacre/scene/mistakes.h"
#include "nacre/scene/planned_swatch.h"

namespace nacre {
namespace {

bool has_swatch(const Table& scene, const std::string& name) {
    const Value* const value = scene.find("swatch");
    const auto* const swatches = value == nullptr ? nullptr : std::get_if<std::shared_ptr<Table>>(&value->data);
    return swatches != nullptr && (*swatches)->find(name) != nullptr;
}

// A contact sheet needs all variants, and which swatch is one is known only when the scene is planned.
bool is_wanted(const Variant& variant, const Table& scene, const std::vector<std::string>& only) {
    return only.empty() || std::any_of(only.begin(), only.end(), [&](const std::string& name) {
               return name == variant.name || name.starts_with(variant.name + "_") || has_swatch(scene, name);
           });
}

bool is_sheet(const PlannedSwatch& swatch) {
    return swatch.kind == SwatchKind::contact_sheet;
}

// What the name of the variant replaces: what the scene calls its only LUT. Empty if there are several.
std::string only_name(const std::vector<PlannedLut>& luts) {
    const auto is_of_first = [&](const PlannedLut& lut) { return lut.entry == luts.front().entry; };
    return !luts.empty() && std::all_of(luts.begin(), luts.end(), is_of_first) ? luts.front().entry : std::string();
}

// Gives everything in the plan its name in the variant.
void rename(Plan& plan, const Variant& variant) {
    const std::string only = only_name(plan.luts);
    const auto renamed = [&](const std::string& name) { return variant.name + "_" + name; };
    const auto renamed_lut = [&](const std::string& name) {
        return only.empty() ? renamed(name) : variant.name + name.substr(only.size());
    };
    plan.variant = variant.name;
    plan.names.clear();
    for (PlannedLut& lut : plan.luts) {
        lut.name = renamed_lut(lut.name);
        lut.where = variant.where;
        plan.names.push_back(lut.name);
    }
    for (PlannedSwatch& swatch : plan.swatches) {
        if (!is_sheet(swatch)) swatch.name = renamed(swatch.name);
        for (std::string& label : swatch.labels) label = renamed_lut(label);
        plan.names.push_back(swatch.name);
    }
}

// Moves what the contact sheets of the plan show to those of the first plan.
void move_sheets(Plan& plan, Plan& first) {
    for (PlannedSwatch& swatch : plan.swatches) {
        if (!is_sheet(swatch)) continue;
        for (PlannedSwatch& sheet : first.swatches) {
            if (sheet.name != swatch.name) continue;
            std::move(swatch.jobs.begin(), swatch.jobs.end(), std::back_inserter(sheet.jobs));
            std::move(swatch.labels.begin(), swatch.labels.end(), std::back_inserter(sheet.labels));
        }
    }
    std::erase_if(plan.swatches, is_sheet);
}

void keep_wanted(Plan& plan, const std::vector<std::string>& only) {
    const PlanRequest request{only};
    std::erase_if(plan.luts, [&](const PlannedLut& lut) { return !request.wants(lut.name); });
    std::erase_if(plan.swatches, [&](const PlannedSwatch& swatch) { return !request.wants(swatch.name); });
}

Plan plan_variant(const Table& scene, const Variant& variant, const SceneRequest& request,
                  const PlanTable& plan_table) {
    Table changed = copy_of(scene, "variants");
    for (const SceneEdit& edit : variant.edits) set_key(changed, edit);
    Plan plan = plan_table(changed, request);
    add_edits(plan, variant.edits);
    rename(plan, variant);
    return plan;
}

// Lines of messages, each once: most mistakes and warnings are those of the scene, and so of every variant.
class Lines {
public:
    /// @return whether it is a new one
    bool add(const std::string& line) {
        const bool is_new = known_.insert(line).second;
        if (is_new) lines_.push_back(line);
        return is_new;
    }
    void add_all(const std::string& message) {
        std::istringstream lines(message);
        for (std::string line; std::getline(lines, line);) add(line);
    }
    const std::vector<std::string>& all() const { return lines_; }

private:
    std::vector<std::string> lines_;
    std::set<std::string> known_;
};

}  // namespace

std::vector<Plan> plan_variants(const Table& scene, const std::vector<Variant>& variants, const SceneRequest& request,
                                const PlanTable& plan_table) {
    std::vector<Plan> plans;
    std::vector<std::string> other_names;
    Lines mistakes;
    Lines warnings;
    SceneRequest own = request;
    own.only.clear();
    if (request.on_warning) {
        own.on_warning = [&](const std::string& warning) {
            if (warnings.add(warning)) request.on_warning(warning);
        };
    }
    for (const Variant& variant : variants) {
        if (!plans.empty() && !is_wanted(variant, scene, request.only)) {
            other_names.push_back(variant.name);
            continue;
        }
        try {
            plans.push_back(plan_variant(scene, variant, own, plan_table));
            if (plans.size() > 1) move_sheets(plans.back(), plans.front());
        } catch (const IoError&) {
            throw;
        } catch (const Error& error) {
            mistakes.add_all(error.what());
        }
    }
    throw_lines(mistakes.all());
    plans.front().names.insert(plans.front().names.end(), other_names.begin(), other_names.end());
    for (Plan& plan : plans) keep_wanted(plan, request.only);
    return plans;
}

void add_edits(Plan& plan, const std::vector<SceneEdit>& edits) {
    for (PlannedLut& lut : plan.luts) {
        for (const SceneEdit& edit : edits) lut.edits.push_back(edit_text(edit));
    }
}

}  // namespace nacre
