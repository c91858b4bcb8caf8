#include "nacre/scene/output_names.h"

#include "nacre/base/error.h"
#include "nacre/lut/formats.h"
#include "nacre/lut/planned_lut.h"
#include "nacre/scene/planned_swatch.h"

namespace nacre {

std::vector<std::string> output_files(const PlannedLut& lut) {
    std::vector<std::string> files;
    for (const LutOutput output : lut.outputs)
        files.push_back(lut.name + "." + std::string(name_of(output_words, output)));
    return files;
}

std::vector<std::string> output_files(const PlannedSwatch& swatch) {
    return {swatch.name + ".png"};
}

std::string preview_file(const PlannedLut& lut) {
    return lut.name + ".preview.png";
}

void OutputNames::claim(const Plan& plan) {
    for (const PlannedLut& lut : plan.luts) {
        for (const std::string& file : output_files(lut)) claim(file, lut.where);
        if (lut.preview != Preview::none) claim(preview_file(lut), lut.where);
    }
    for (const PlannedSwatch& swatch : plan.swatches) {
        for (const std::string& file : output_files(swatch)) claim(file, swatch.where);
    }
}

void OutputNames::claim(const std::string& file, const Where& where) {
    std::string key = file;
    for (char& c : key) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
    const auto [first, is_new] = taken_.emplace(std::move(key), where.text());
    if (is_new) return;
    throw Error(where.text() + ": this would write " + file + ", and so would " + first->second +
                "; rename one of them");
}

}  // namespace nacre
