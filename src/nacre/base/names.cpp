#include "nacre/base/names.h"

#include <algorithm>
#include <numeric>
#include <utility>

namespace nacre {
namespace {

// A longer name is not a typing mistake; the limit bounds the time that hostile input can take.
constexpr std::size_t longest_name = 200;

std::string lower_case(std::string_view text) {
    std::string result(text);
    for (char& c : result) {
        if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
    }
    return result;
}

// Insertions, deletions and replacements between two names, one row of the table at a time.
std::size_t edit_distance(const std::string& a, const std::string& b) {
    std::vector<std::size_t> row(b.size() + 1);
    std::iota(row.begin(), row.end(), std::size_t{0});
    for (std::size_t i = 1; i <= a.size(); ++i) {
        std::size_t diagonal = row[0];
        row[0] = i;
        for (std::size_t j = 1; j <= b.size(); ++j) {
            const std::size_t replaced = diagonal + (a[i - 1] == b[j - 1] ? 0 : 1);
            diagonal = row[j];
            row[j] = std::min({row[j] + 1, row[j - 1] + 1, replaced});
        }
    }
    return row.back();
}

struct Near {
    std::size_t distance;  // what counts
    std::size_t edits;     // among equals
    const std::string* name;
};

Near nearness(const std::string& wanted, const std::string& candidate) {
    const std::string name = lower_case(candidate);
    const std::size_t edits = edit_distance(wanted, name);
    // Nearly every name contains parts of fewer than three letters.
    const std::string& part = wanted.size() < name.size() ? wanted : name;
    const std::string& whole = wanted.size() < name.size() ? name : wanted;
    const bool contained = part.size() >= 3 && whole.find(part) != std::string::npos;
    return {contained ? std::min<std::size_t>(edits, 1) : edits, edits, &candidate};
}

}  // namespace

std::vector<std::string> nearest_names(std::string_view wanted, std::span<const std::string> candidates,
                                       std::size_t max_count) {
    if (wanted.empty() || wanted.size() > longest_name) return {};
    std::vector<Near> near;
    const std::string key = lower_case(wanted);
    for (const std::string& candidate : candidates) {
        if (candidate.empty() || candidate.size() > longest_name) continue;
        const Near n = nearness(key, candidate);
        if (n.distance <= std::max<std::size_t>(2, std::max(key.size(), candidate.size()) / 3)) near.push_back(n);
    }
    std::stable_sort(near.begin(), near.end(), [](const Near& a, const Near& b) {
        return std::pair(a.distance, a.edits) < std::pair(b.distance, b.edits);
    });
    std::vector<std::string> result;
    for (const Near& n : near) {
        if (result.size() == max_count) break;
        if (std::find(result.begin(), result.end(), *n.name) == result.end()) result.push_back(*n.name);
    }
    return result;
}

std::string known_like(std::string_view wanted, std::span<const std::string> known) {
    constexpr std::size_t a_few = 5;
    const auto near = nearest_names(wanted, known, a_few);
    if (!near.empty()) return comma_separated(near);
    return comma_separated(known.first(std::min(known.size(), a_few))) + (known.size() > a_few ? ", ..." : "");
}

std::string in_quotes(std::string_view name) {
    constexpr std::size_t longest = 60;
    std::string shown(name.substr(0, longest));
    for (char& c : shown) {
        if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f)
            c = '?';  // a line break would look like a second message
    }
    return '"' + shown + (name.size() <= longest ? "\"" : "...\"");
}

std::string comma_separated(std::span<const std::string> names) {
    std::string result;
    for (const std::string& name : names) {
        if (!result.empty()) result += ", ";
        result += name;
    }
    return result;
}

}  // namespace nacre
