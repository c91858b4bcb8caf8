#include "cli/number_ranges.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <optional>
#include <string_view>
#include <system_error>

#include "nacre/base/error.h"
#include "nacre/base/names.h"
#include "pipeline/spectrum.h"

namespace nacre {
namespace {

constexpr double most_numbers = 1e6;  // as many as a CSV file may have rows

std::optional<double> number_of(std::string_view word) {
    double number = 0.0;
    const auto [end, failure] = std::from_chars(word.data(), word.data() + word.size(), number);
    if (word.empty() || failure != std::errc() || end != word.data() + word.size()) return std::nullopt;
    return number;
}

[[noreturn]] void refuse_range(const std::string& option, const std::string& word, const std::string& why) {
    throw Error(option + " " + in_quotes(word) + " " + why + "; write a number or FIRST:LAST:STEP, for example 0:90:5");
}

std::vector<double> numbers_of(const std::string& word, const std::string& option) {
    const std::size_t first_colon = word.find(':');
    if (first_colon == std::string::npos) {
        const std::optional<double> number = number_of(word);
        if (!number) refuse_range(option, word, "is not a number");
        return {*number};
    }
    const std::size_t second_colon = std::min(word.find(':', first_colon + 1), word.size());
    const std::string_view text = word;
    const std::optional<double> first = number_of(text.substr(0, first_colon));
    const std::optional<double> last = number_of(text.substr(first_colon + 1, second_colon - first_colon - 1));
    const std::optional<double> step = number_of(text.substr(std::min(second_colon + 1, text.size())));
    if (!first || !last || !step || !std::isfinite(*first) || !std::isfinite(*last) || !std::isfinite(*step))
        refuse_range(option, word, "is not a range");
    if (!(*step > 0.0)) refuse_range(option, word, "has no step above 0");
    if (*last < *first) refuse_range(option, word, "ends before it begins");
    if ((*last - *first) / *step > most_numbers) refuse_range(option, word, "has more than a million numbers");
    return even_steps(*first, *last, *step);
}

}  // namespace

std::vector<double> numbers_in_ranges(const std::vector<std::string>& words, const std::string& option) {
    std::vector<double> all;
    for (const std::string& word : words) {
        const std::vector<double> numbers = numbers_of(word, option);
        all.insert(all.end(), numbers.begin(), numbers.end());
    }
    return all;
}

}  // namespace nacre
