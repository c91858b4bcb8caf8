#include "cli/cost_report.h"

#include <algorithm>
#include <array>

#include "cli/plot_style.h"
#include "cli/report.h"
#include "cli/text_table.h"
#include "io/image/gnuplot.h"
#include "nacre/base/text.h"
#include "nacre/lut/job.h"

namespace nacre {

// Compiled in from src/cli.
extern const std::string_view cost_gp;

namespace {

struct FamilyText {
    CostFamily family;
    std::string_view name;     // in CSV and JSON
    std::string_view heading;  // in the table
};
constexpr std::array family_texts{
    FamilyText{CostFamily::choice, "choice", "nacre's choice for a bound"},
    FamilyText{CostFamily::integral, "integral", "from spectrum to XYZ, everything else as exact as possible"},
    FamilyText{CostFamily::fixed_size, "fixed_size", "sizes fixed by hand, spectra integrated exactly"},
    FamilyText{CostFamily::mistake, "mistake", "common mistakes, at 256 texels in half"},
    FamilyText{CostFamily::effect, "effect", "effects switched off in turn, everything else as exact as possible"},
};

std::string_view family_name(CostFamily family) {
    for (const FamilyText& text : family_texts) {
        if (text.family == family) return text.name;
    }
    return {};
}

std::string bytes_text(std::size_t bytes) {
    return bytes < 10240 ? std::to_string(bytes) + " B" : std::to_string((bytes + 512) / 1024) + " kB";
}

// What stands beside a point in the picture. Choices that came out alike share one: "5, 2".
std::string mark_of(const std::vector<CostRow>& rows, std::size_t i) {
    const CostCase& cost = rows[i].cost;
    if (cost.family != CostFamily::choice) return cost.label;
    const auto is_twin = [&](std::size_t j) {
        const CostCase& other = rows[j].cost;
        return other.family == CostFamily::choice && other.job.width == cost.job.width &&
               other.job.height == cost.job.height && other.format == cost.format;
    };
    if (i + 1 < rows.size() && is_twin(i + 1)) return "=";  // the next one speaks for both
    std::string mark = cost.label;
    for (std::size_t j = i; j > 0 && is_twin(j - 1); --j) mark = rows[j - 1].cost.label + "; " + mark;
    return mark;
}

}  // namespace

std::vector<std::string> cost_lines(const std::vector<CostRow>& rows) {
    std::vector<std::vector<std::string>> cells;
    for (const FamilyText& text : family_texts) {
        const bool is_empty =
            std::none_of(rows.begin(), rows.end(), [&](const CostRow& row) { return row.cost.family == text.family; });
        if (is_empty) continue;
        if (!cells.empty()) cells.emplace_back();
        cells.push_back({std::string(text.heading), "x", "texels", "format", "size", "dE00", "computing", "deciding",
                         "measuring", "all in all"});
        for (const CostRow& row : rows) {
            const CostCase& cost = row.cost;
            if (cost.family != text.family) continue;
            cells.push_back({"  " + cost.label + (cost.is_reached ? "" : " (not reached)"), cost.axis,
                             size_text(cost.job), cost.format, bytes_text(cost.bytes), short_number(row.de00),
                             duration_text(row.computing_seconds),
                             row.deciding_seconds > 0.0 ? duration_text(row.deciding_seconds) : "",
                             duration_text(row.measuring_seconds), duration_text(row.all_seconds())});
        }
    }
    return table_lines(cells, {false, false, true, false, true, true, true, true, true, true});
}

std::string cost_csv(const std::vector<CostRow>& rows, const std::string& comment) {
    std::string text = "# " + comment +
                       "\nfamily,label,axis,format,width,height,bytes,bound,de00,computing_seconds,deciding_seconds,"
                       "measuring_seconds,all_seconds,predicted_de00,mark\n";
    for (std::size_t i = 0; i < rows.size(); ++i) {
        const CostRow& row = rows[i];
        const CostCase& cost = row.cost;
        text += std::string(family_name(cost.family)) + "," + cost.label + "," + cost.axis + "," + cost.format + "," +
                std::to_string(cost.job.width) + "," + std::to_string(cost.job.height) + "," +
                std::to_string(cost.bytes) + "," + (cost.bound > 0.0 ? number_text(cost.bound) : "") + "," +
                number_text(row.de00) + "," + number_text(row.computing_seconds) + "," +
                number_text(row.deciding_seconds) + "," + number_text(row.measuring_seconds) + "," +
                number_text(row.all_seconds()) + "," + (cost.predicted > 0.0 ? number_text(cost.predicted) : "") + "," +
                mark_of(rows, i) + "\n";
    }
    return text;
}

Json cost_json(const std::vector<CostRow>& rows) {
    Json json = Json::array();
    for (const CostRow& row : rows) {
        const CostCase& cost = row.cost;
        Json entry{{"family", family_name(cost.family)},
                   {"label", cost.label},
                   {"axis", cost.axis},
                   {"format", cost.format},
                   {"width", cost.job.width},
                   {"height", cost.job.height},
                   {"bytes", cost.bytes},
                   {"de00", row.de00},
                   {"computing_seconds", row.computing_seconds},
                   {"deciding_seconds", row.deciding_seconds},
                   {"measuring_seconds", row.measuring_seconds},
                   {"all_seconds", row.all_seconds()}};
        if (cost.family == CostFamily::choice) {
            entry["max_de00"] = cost.bound;
            entry["reached"] = cost.is_reached;
            entry["predicted_de00"] = cost.predicted;
        }
        json.push_back(entry);
    }
    return json;
}

std::vector<std::pair<std::string, std::string>> cost_picture(const std::vector<CostRow>& rows, const std::string& name,
                                                              const std::string& title, double bound,
                                                              const std::string& comment) {
    // What the script cannot know; letters that gnuplot would take for markup do not occur in names.
    const std::string script = "# " + comment + "\n# Run in this folder: gnuplot " + name + ".gp\nname = '" + name +
                               "'\ntitle = '" + title + "'\nbound = " + number_text(bound) + "\n" +
                               std::string(cost_gp);
    NamedFiles files{
        {name + ".csv", cost_csv(rows, comment)}, {name + ".gp", script}, {plot_style_file, plot_style_script()}};
    GnuplotResult plotted = run_gnuplot(files, name + ".gp", {name + ".png"});
    return {{name + ".png", plotted.files.at(name + ".png")},
            {name + ".csv", files.at(name + ".csv")},
            {name + ".gp", files.at(name + ".gp")},
            {plot_style_file, files.at(plot_style_file)}};
}

}  // namespace nacre
