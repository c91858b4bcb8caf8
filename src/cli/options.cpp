// The command line, by CLI11: which takes every value as text, so that what is wrong with a value is said here, in one
// way for all options. CLI11's headers are the slowest to compile of all, so no other file includes them.
#include "cli/options.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <charconv>
#include <cstddef>
#include <filesystem>
#include <iostream>
#include <list>
#include <system_error>

#include "nacre/base/error.h"
#include "nacre/base/names.h"
#include "nacre/base/text.h"
#include "pipeline/version.h"

namespace nacre {
namespace {

constexpr const char* description =
    "nacre turns palette picks, films, stacks, gratings, crystals, scattering and measurements into colour-managed\n"
    "angle-to-RGB lookup textures for iridescent surfaces.";

constexpr const char* main_footer =
    "\nExit codes: 0 success; 1 some LUTs failed, the others were written; 2 the scene or the command line is wrong,\n"
    "nothing was written; 3 input or output failed; 4 accuracy or verification not reached; 130 stopped by\n"
    "Ctrl+C; 143 stopped by SIGTERM.\n\n"
    "Example:\n  nacre bake configs/scenes/morpho.toml -o out\n";

// "--output" of "-o,--output".
std::string long_name(const Option& option) {
    return option.names.substr(option.names.rfind(',') + 1);
}

bool is_option(const std::string& word) {
    return word.size() > 1 && word.front() == '-';
}

// An option as CLI11 fills it.
struct Given {
    const Option* option;
    std::vector<std::string> words;
};

// ---- from words to values

[[noreturn]] void refuse(const Option& option, const std::string& word, const std::string& why) {
    throw Error(long_name(option) + " " + in_quotes(word) + " " + why);
}

template <typename Number>
Number number_in(const Option& option, const std::string& word) {
    constexpr bool is_whole = std::is_integral_v<Number>;
    Number value{};
    const char* const end = word.data() + word.size();
    const auto [rest, failure] = std::from_chars(word.data(), end, value);
    std::string allowed;
    if (option.range) {
        allowed = "; allowed [" + limit_text(option.range->low) + ", " + limit_text(option.range->high) + "]";
    }
    if ((failure != std::errc() && failure != std::errc::result_out_of_range) || rest != end || word.empty())
        refuse(option, word, std::string(is_whole ? "is not a whole number" : "is not a number") + allowed);
    const auto real = static_cast<double>(value);
    const bool is_allowed = !option.range || (real >= option.range->low && real <= option.range->high);
    if (failure != std::errc() || !is_allowed) refuse(option, word, "is out of range" + allowed);
    return value;
}

void store(const Given& given) {
    const Option& option = *given.option;
    const std::vector<std::string>& words = given.words;
    if (words.empty()) return;
    for (const std::string& word : words) {
        if (!option.allowed.empty() &&
            std::find(option.allowed.begin(), option.allowed.end(), word) == option.allowed.end())
            refuse(option, word, "is unknown; known: " + comma_separated(option.allowed));
    }
    if (auto* const* texts = std::get_if<std::vector<std::string>*>(&option.target)) {
        **texts = words;
        return;
    }
    if (auto* const* numbers = std::get_if<std::vector<double>*>(&option.target)) {
        for (const std::string& word : words) (*numbers)->push_back(number_in<double>(option, word));
        return;
    }
    if (words.size() > 1) {
        throw Error(is_option(option.names) ? long_name(option) + " is given twice; give it once"
                                            : "unexpected argument " + in_quotes(words[1]));
    }
    if (auto* const* text = std::get_if<std::string*>(&option.target)) **text = words.front();
    if (auto* const* whole = std::get_if<int*>(&option.target)) **whole = number_in<int>(option, words.front());
    if (auto* const* real = std::get_if<double*>(&option.target)) **real = number_in<double>(option, words.front());
}

// ---- declaring options

std::string default_text(const Option& option) {
    if (auto* const* text = std::get_if<std::string*>(&option.target)) return **text;
    if (auto* const* whole = std::get_if<int*>(&option.target)) return std::to_string(**whole);
    return {};
}

std::string help_text(const Option& option) {
    std::string text = option.help;
    if (option.range) text += " [" + limit_text(option.range->low) + ", " + limit_text(option.range->high) + "]";
    return text;
}

void declare(CLI::App& app, const Option& option, Given& given) {
    if (auto* const* flag = std::get_if<bool*>(&option.target)) {
        CLI::Option* const declared = app.add_flag(option.names, **flag, option.help);
        for (const std::string& other : option.excludes) declared->excludes(other);
        return;
    }
    CLI::Option* const declared = app.add_option(option.names, given.words, help_text(option));
    declared->type_name(option.value_name);
    const bool takes_words = !option.names.starts_with('-');
    const bool is_single = !std::holds_alternative<std::vector<std::string>*>(option.target) &&
                           !std::holds_alternative<std::vector<double>*>(option.target);
    if (is_single) declared->expected(1)->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
    if (!takes_words) declared->allow_extra_args(false);
    if (option.is_required) declared->required();
    if (option.shows_default) declared->default_str(default_text(option));
    for (const std::string& other : option.excludes) declared->excludes(other);
}

// ---- lists

// A word behind a list that is meant for the command itself: `--only a b scene.toml`.
bool is_file(const std::string& word) {
    std::error_code failure;
    return word.ends_with(".toml") || word.find('/') != std::string::npos ||
           std::filesystem::is_regular_file(word, failure);
}

void add_items(std::vector<std::string>& words, const std::string& option, const std::string& list) {
    std::size_t begin = 0;
    while (begin <= list.size()) {
        const std::size_t end = std::min(list.find(',', begin), list.size());
        if (end > begin) words.insert(words.end(), {option, list.substr(begin, end - begin)});
        begin = end + 1;
    }
}

// `--only a b`, `--only a,b` and `--only=a,b` become `--only a --only b`.
std::vector<std::string> with_lists_spread(const std::vector<std::string>& words, const Command* command) {
    std::vector<std::string> names;
    if (command != nullptr) {
        for (const Option& option : command->options) {
            if (option.is_list) names.push_back(long_name(option));
        }
    }
    std::vector<std::string> spread;
    for (std::size_t i = 0; i < words.size(); ++i) {
        const std::string name = words[i].substr(0, words[i].find('='));
        const bool is_list = std::find(names.begin(), names.end(), name) != names.end();
        const bool has_value = name.size() < words[i].size();
        const bool is_last = i + 1 >= words.size() || is_option(words[i + 1]);
        if (!is_list || (!has_value && is_last)) {
            spread.push_back(words[i]);  // of a list without a value CLI11 says that it is missing
        } else if (has_value) {
            add_items(spread, name, words[i].substr(name.size() + 1));
        } else {
            add_items(spread, name, words[++i]);
            while (i + 1 < words.size() && !is_option(words[i + 1]) && !is_file(words[i + 1]))
                add_items(spread, name, words[++i]);
        }
    }
    return spread;
}

// ---- what CLI11 refuses

std::vector<std::string> option_names(const Command* command) {
    std::vector<std::string> names{"--help", "--json", "--quiet", "--verbose"};
    if (command == nullptr) return names;
    for (const Option& option : command->options) {
        if (option.names.starts_with('-')) names.push_back(long_name(option));
    }
    return names;
}

std::string unexpected(const std::string& word, const Command* command) {
    if (!is_option(word)) return "unexpected argument " + in_quotes(word);
    const std::vector<std::string> near = nearest_names(word, option_names(command));
    return "unknown option " + in_quotes(word) + (near.empty() ? "" : "; did you mean " + comma_separated(near) + "?");
}

// In our words where CLI11's name a C++ type or quote nothing.
std::string refusal(const CLI::ParseError& error, const CLI::App& app, const Command* command) {
    const std::vector<std::string> rest = app.remaining(true);
    if (!rest.empty()) return unexpected(rest.front(), command);
    std::string text = error.what();
    if (dynamic_cast<const CLI::ArgumentMismatch*>(&error) != nullptr && command != nullptr) {
        const std::string name = text.substr(0, text.find(':'));
        for (const Option& option : command->options) {
            if (long_name(option) == name) return name + " needs a value: " + name + " " + option.value_name;
        }
    }
    return text;
}

std::string known_commands(const std::vector<Command>& commands) {
    std::vector<std::string> names;
    for (const Command& command : commands) names.push_back(command.name);
    return comma_separated(names);
}

// The command is the first word that is no option. CLI11 would call a misspelt one a missing one.
const Command* find_command(const std::vector<std::string>& words, const std::vector<Command>& commands) {
    const auto word = std::find_if(words.begin(), words.end(), [](const std::string& w) { return !is_option(w); });
    if (word == words.end()) return nullptr;
    const auto found =
        std::find_if(commands.begin(), commands.end(), [&](const Command& command) { return command.name == *word; });
    if (found != commands.end()) return &*found;
    throw Error("unknown command " + in_quotes(*word) + "; known: " + known_commands(commands));
}

}  // namespace

Asked parse_command_line(int argc, const char* const* argv, const std::vector<Command>& commands) {
    Asked asked;
    CLI::App app(description, "nacre");
    app.set_version_flag("--version", "nacre " + std::string(nacre_version()));
    app.footer(main_footer);
    app.require_subcommand(1);
    app.fallthrough();
    app.allow_extras();
    app.add_flag("--json", asked.console.json, "print results as JSON on standard output");
    app.add_flag("-q,--quiet", asked.console.quiet, "print errors only");
    app.add_flag("-v,--verbose", asked.console.verbose, "report each step on standard error");

    const std::vector<std::string> all(argv + std::min(argc, 1), argv + argc);
    const Command* const command = find_command(all, commands);
    std::list<Given> values;  // CLI11 keeps references
    for (const Command& one : commands) {
        CLI::App* const declared = app.add_subcommand(one.name, one.summary);
        declared->footer("All commands accept --json, --quiet and --verbose.\n" + one.footer);
        if (&one != command) continue;
        for (const Option& option : one.options) declare(*declared, option, values.emplace_back(Given{&option, {}}));
    }
    const std::string see = std::string("; see nacre ") + (command != nullptr ? command->name + " " : "") + "--help";
    try {
        std::vector<std::string> words = with_lists_spread(all, command);
        std::reverse(words.begin(), words.end());  // as CLI11 wants them
        app.parse(words);
        const std::vector<std::string> rest = app.remaining(true);
        if (!rest.empty()) throw Error(unexpected(rest.front(), command));
        for (const Given& given : values) store(given);
        asked.command = command;
    } catch (const CLI::Success& request) {
        app.exit(request);  // --help, --version
    } catch (const CLI::ParseError& error) {
        if (command == nullptr && app.remaining(true).empty())
            throw Error("a command is missing; known: " + known_commands(commands) + see);
        throw Error(refusal(error, app, command) + see);
    } catch (const Error& error) {
        throw Error(error.what() + see);
    }
    return asked;
}

}  // namespace nacre
