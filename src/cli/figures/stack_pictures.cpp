#include "cli/figures/stack_pictures.h"

#include <cmath>
#include <cstddef>
#include <string_view>
#include <vector>

#include "nacre/base/text.h"
#include "nacre/paper/paper_judged.h"

namespace nacre {

// Compiled in from src/cli/figures.
extern const std::string_view stacks_gp;

namespace {

// A specimen with everything that was computed of it.
struct Judged {
    const Specimen& specimen;
    std::vector<ExactStack> stacks;
    Series spectra;
    Series angles;
    Series table;
    Series summary;

    // "12.7", or a dash where there is no such number.
    std::string at(const std::string& column, double angle_deg, int decimals = 1) const {
        return text(angles.value(angle_deg, column), decimals);
    }
    // Of the summary: stack counts from 0.
    std::string worst(std::size_t stack, const std::string& column, int decimals = 1) const {
        return text(summary.value(static_cast<double>(stack + 1), column), decimals);
    }

private:
    static std::string text(double value, int decimals) {
        return std::isnan(value) ? "–" : fixed_text(value, decimals);
    }
};

std::string markdown_row(const std::vector<std::string>& cells) {
    std::string line = "|";
    for (const std::string& cell : cells) line += " " + cell + " |";
    return line + "\n";
}

std::string table_at_angles(const Judged& judged) {
    std::string text = markdown_row({"stack", "angle", "palette's peak (nm)", "exact peak (nm)", "error (nm)",
                                     "palette's width at half height (nm)", "exact (nm)", "palette's height", "exact",
                                     "ΔE00", "scaled", "picked anew"});
    text += "|---|--:|--:|--:|--:|--:|--:|--:|--:|--:|--:|--:|\n";
    for (const ExactStack& stack : judged.stacks) {
        for (const double angle : judged.specimen.angles_deg) {
            const auto exact = [&](const char* column, int decimals) {
                return judged.at(stack.name + column, angle, decimals);
            };
            text += markdown_row({stack.title, number_text(angle) + "°", judged.at("palette_nm", angle, 2),
                                  exact("_nm", 2), exact("_error_nm", 2),
                                  judged.at("palette_half_height_width_nm", angle), exact("_half_height_width_nm", 1),
                                  judged.at("palette_height", angle, 2), exact("_height", 2), exact("_de00", 1),
                                  exact("_scaled_de00", 1), exact("_repicked_de00", 1)});
        }
    }
    return text;
}

std::string table_of_errors(const Judged& judged) {
    std::string text = markdown_row(
        {"stack", "what", "largest, at these angles", "mean", "largest, 0–60°", "mean", "largest, 0–90°", "mean"});
    text += "|---|---|--:|--:|--:|--:|--:|--:|\n";
    for (std::size_t i = 0; i < judged.stacks.size(); ++i) {
        const auto row = [&](const std::string& what, const std::string& column) {
            std::vector<std::string> cells{judged.stacks[i].title, what};
            for (const char* range : {"_here", "_0_60", "_0_90"}) {
                cells.push_back(judged.worst(i, "largest_" + column + range));
                cells.push_back(judged.worst(i, "mean_" + column + range));
            }
            return markdown_row(cells);
        };
        text += row("peak (nm)", "error_nm") + row("peak, picked anew (nm)", "repicked_error_nm") +
                row("ΔE00", "de00") + row("ΔE00, scaled", "scaled_de00") + row("ΔE00, picked anew", "repicked_de00");
    }
    return text;
}

constexpr const char* how_to_read =
    "Exact means: every wave between all layers, both polarisations, reflected in the mirror's direction. A peak's "
    "error "
    "is the palette's less the stack's; a stack has a band as long as its spectrum falls to half of the peak on both "
    "sides. ΔE00 compares colours as they are (D65, 2°, white is the perfect reflector). *Scaled* first multiplies the "
    "stack's colours, by one number for all angles, so that its Y at the first pick is the palette's: what is left is "
    "hue, saturation and how brightness changes with the angle, but not how bright the whole is. *Picked anew* "
    "compares "
    "the stack with another palette, whose picks are that stack's own peak, width (3/2 of that at half height) and "
    "height at the specimen's two angles: what is left there is the error of the paper's approximation, the rest is "
    "the "
    "picks'.\n\n";

std::string morpho_verdict(const Judged& judged) {
    return "**Verdict.** The palette moves the Morpho's peak as its own stack does, within " +
           judged.worst(0, "largest_error_nm_here") +
           " nm at the paper's angles, but it is no picture of even films of cuticle and air: those reflect a band " +
           judged.at("perfect_half_height_width_nm", 0.0, 0) + " nm wide at half height where the picks say " +
           judged.at("palette_half_height_width_nm", 0.0, 0) +
           " nm, which neither more films nor uneven ones mend; so colours differ by up to " +
           judged.worst(0, "largest_de00_here", 0) + " at the paper's angles, " +
           judged.worst(0, "largest_scaled_de00_here", 0) + " with brightness set aside, and still " +
           judged.worst(0, "largest_repicked_de00_here", 0) +
           " with picks from the stack itself, most of all because half a cosine has none of the light that layers "
           "reflect beside "
           "their band.";
}

std::string beetle_verdict(const Judged& judged) {
    return "**Verdict.** The formula for the peak fits well, within " + judged.worst(0, "largest_error_nm_here") +
           " nm of the stack that the picks imply; against the published indices the peak is off by up to " +
           judged.worst(1, "largest_error_nm_here") +
           " nm, because the two picks ask for a mean index above both of them; colours differ by up to " +
           judged.worst(1, "largest_de00_here", 0) + " at the paper's angles, " +
           judged.worst(1, "largest_scaled_de00_here", 0) + " with brightness set aside and " +
           judged.worst(1, "largest_repicked_de00_here", 0) +
           " with picks from the stack itself, most of all because the surface's own reflection, white and growing "
           "towards "
           "grazing, "
           "is not in the palette, and because 16 layers reflect " +
           judged.at("published_height", 60.0, 2) + " where the second pick says 1.";
}

std::string shows(const Judged& judged) {
    const bool is_morpho = judged.specimen.name == paper_morpho().name;
    std::string text = "The palette of `configs/scenes/" + judged.specimen.name +
                       ".toml` beside layers that are solved exactly; data for every degree, at the paper's angles "
                       "(`_table`) and largest errors (`_summary`).\n\n";
    for (const ExactStack& stack : judged.stacks) text += "- *" + stack.title + "*: " + stack.facts + "\n";
    return text + "\n" + how_to_read + table_at_angles(judged) + "\n" + table_of_errors(judged) + "\n" +
           (is_morpho ? morpho_verdict(judged) : beetle_verdict(judged));
}

// What the script has to know before its first line.
std::string script(const Judged& judged) {
    std::string names;
    std::string titles;
    std::string degrees;
    for (const ExactStack& stack : judged.stacks) {
        names += (names.empty() ? "" : " ") + stack.name;
        titles += (titles.empty() ? "'" : ", '") + stack.title + "'";
    }
    for (const double angle : judged.specimen.angles_deg) degrees += (degrees.empty() ? "" : " ") + number_text(angle);
    return "# A palette beside exact stacks. Run in this folder: gnuplot stacks_" + judged.specimen.name +
           ".gp\nspecimen = '" + judged.specimen.name + "'\nspecimen_title = '" + judged.specimen.title +
           "'\nstacks = '" + names + "'\narray titles[" + std::to_string(judged.stacks.size()) + "] = [" + titles +
           "]\nshown_deg = '" + degrees + "'\n" + std::string(stacks_gp);
}

}  // namespace

PaperFigure stacks_figure(const Specimen& specimen, const std::shared_ptr<const Light>& light) {
    Judged judged{specimen, exact_stacks(specimen), {}, {}, {}, {}};
    judged.spectra = judged_spectra(specimen, judged.stacks);
    judged.angles = judged_angles(specimen, judged.stacks, light);
    judged.table = judged_table(specimen, judged.stacks, judged.angles);
    judged.summary = judged_summary(specimen, judged.stacks, judged.angles);
    return {"stacks_" + specimen.name,
            "The palette beside exact stacks: " + specimen.title,
            shows(judged),
            {judged.angles, judged.spectra, judged.table, judged.summary, paper_picks(specimen)},
            script(judged),
            {}};
}

}  // namespace nacre
