#pragma once

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <optional>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace nacre::reference {

/// A file of tests/reference/data: line 1 is a comment, line 2 the names of the columns; no quotes.
struct Csv {
    std::vector<std::string> names;
    std::vector<std::vector<std::string>> rows;

    const std::string& text(std::size_t row, const std::string& name) const {
        const auto found = std::find(names.begin(), names.end(), name);
        if (found == names.end()) throw std::runtime_error("no column " + name);
        return rows.at(row).at(static_cast<std::size_t>(found - names.begin()));
    }
    /// The double nearest to the printed decimal; nothing for a blank field.
    std::optional<double> number(std::size_t row, const std::string& name) const {
        const std::string& field = text(row, name);
        if (field.empty()) return std::nullopt;
        return std::strtod(field.c_str(), nullptr);
    }
};

inline std::vector<std::string> split_at_commas(const std::string& line) {
    std::vector<std::string> fields;
    std::istringstream stream(line + ",");  // the added comma keeps a blank last field
    for (std::string field; std::getline(stream, field, ',');) fields.push_back(field);
    return fields;
}

inline Csv read_csv(const std::string& file_name) {
    const std::string path = std::string(NACRE_REFERENCE_DATA_DIR) + "/" + file_name;
    std::ifstream file(path);
    std::string line;
    if (!std::getline(file, line) || line.substr(0, 1) != "#") throw std::runtime_error("cannot read " + path);
    Csv csv;
    std::getline(file, line);
    csv.names = split_at_commas(line);
    while (std::getline(file, line)) csv.rows.push_back(split_at_commas(line));
    return csv;
}

}  // namespace nacre::reference
