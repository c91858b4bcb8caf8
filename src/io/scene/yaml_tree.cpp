#include "io/scene/yaml_tree.h"

#include <yaml-cpp/eventhandler.h>
#include <yaml-cpp/exceptions.h>
#include <yaml-cpp/mark.h>
#include <yaml-cpp/parser.h>

#include <algorithm>
#include <cstddef>
#include <sstream>
#include <utility>

#include "nacre/base/error.h"
#include "nacre/base/names.h"

namespace nacre {
namespace {

constexpr std::size_t most_levels = 32;
constexpr std::size_t most_yaml_values = 10000;
constexpr std::size_t tab_width = 8;
constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";

// Lines end in "\n", and there are no tabs. Keeps the number of lines.
std::string plain_text(std::string_view text) {
    std::string result;
    result.reserve(text.size());
    std::size_t line_begin = 0;
    bool is_indentation = true;
    for (std::size_t i = 0; i < text.size(); ++i) {
        char c = text[i];
        if (c == '\r' && i + 1 < text.size() && text[i + 1] == '\n') continue;
        if (c == '\r') c = '\n';
        if (c == '\t') {
            const std::size_t column = result.size() - line_begin;
            result.append(is_indentation ? tab_width - column % tab_width : 1, ' ');
            continue;
        }
        result += c;
        if (c == '\n') line_begin = result.size();
        is_indentation = c == '\n' || (is_indentation && c == ' ');
    }
    return result;
}

// Builds the tree from yaml-cpp's events. Its own tree would follow aliases, and knows no limits.
class TreeBuilder : public YAML::EventHandler {
public:
    TreeBuilder(const std::string& text, const std::string& name) : text_(text), name_(name) {}

    YamlNode take() { return std::move(root_); }

    void OnDocumentStart(const YAML::Mark& mark) override {
        if (documents_++ > 0) fail(mark, "a second document begins; a file has one");
    }
    void OnDocumentEnd() override {}
    void OnNull(const YAML::Mark& mark, YAML::anchor_t) override { add(mark, YamlNode::Kind::nothing); }
    void OnAlias(const YAML::Mark& mark, YAML::anchor_t) override {
        fail(mark, "has an alias (*); write its value out");
    }
    void OnScalar(const YAML::Mark& mark, const std::string&, YAML::anchor_t, const std::string& value) override {
        if (!open_.empty() && open_.back()->kind == YamlNode::Kind::map && !has_key_) {
            begin_entry(mark, value);
            return;
        }
        YamlNode& node = add(mark, YamlNode::Kind::text);
        const auto position = static_cast<std::size_t>(std::max(mark.pos, 0));
        const bool is_block = position < text_.size() && (text_[position] == '|' || text_[position] == '>');
        node.text = value;
        node.text_line = node.line + (is_block ? 1 : 0);
    }
    void OnSequenceStart(const YAML::Mark& mark, const std::string&, YAML::anchor_t,
                         YAML::EmitterStyle::value) override {
        open_.push_back(&add(mark, YamlNode::Kind::list));
    }
    void OnSequenceEnd() override { open_.pop_back(); }
    void OnMapStart(const YAML::Mark& mark, const std::string&, YAML::anchor_t, YAML::EmitterStyle::value) override {
        open_.push_back(&add(mark, YamlNode::Kind::map));
    }
    void OnMapEnd() override { open_.pop_back(); }

private:
    [[noreturn]] void fail(const YAML::Mark& mark, const std::string& message) const {
        throw Error(name_ + ":" + std::to_string(mark.line + 1) + ": " + message);
    }

    void begin_entry(const YAML::Mark& mark, const std::string& key) {
        auto& keys = open_.back()->keys;
        if (std::find(keys.begin(), keys.end(), key) != keys.end())
            fail(mark, "the key " + in_quotes(printable(key)) + " is given twice; give it once");
        keys.push_back(key);
        has_key_ = true;
        key_line_ = mark.line + 1;
    }

    // The pointers to open nodes stay right: a node grows only while it is the innermost one.
    YamlNode& add(const YAML::Mark& mark, YamlNode::Kind kind) {
        if (++values_ > most_yaml_values) fail(mark, "more than " + std::to_string(most_yaml_values) + " values");
        if (open_.size() >= most_levels) fail(mark, "more than " + std::to_string(most_levels) + " levels");
        YamlNode* node = &root_;
        if (!open_.empty()) {
            YamlNode& parent = *open_.back();
            if (parent.kind == YamlNode::Kind::map && !has_key_)
                fail(mark, "a key is not a word; a key must be a word");
            parent.items.emplace_back();
            node = &parent.items.back();
        }
        node->kind = kind;
        // yaml-cpp places a missing value where the next thing begins.
        node->line = has_key_ && kind == YamlNode::Kind::nothing ? key_line_ : mark.line + 1;
        has_key_ = false;
        return *node;
    }

    const std::string& text_;
    const std::string& name_;
    YamlNode root_;
    std::vector<YamlNode*> open_;
    bool has_key_ = false;  // in the innermost open map
    int key_line_ = 0;
    std::size_t values_ = 0;
    int documents_ = 0;
};

}  // namespace

YamlNode parse_yaml(std::string_view text, const std::string& name) {
    if (text.starts_with(byte_order_mark)) text.remove_prefix(byte_order_mark.size());
    if (const std::size_t zero = text.find('\0'); zero != std::string_view::npos) {
        const auto line = 1 + std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(zero), '\n');
        throw Error(name + ":" + std::to_string(line) + ": has a zero byte; the file must be text in UTF-8");
    }
    const std::string plain = plain_text(text);
    TreeBuilder builder(plain, name);
    std::istringstream stream(plain);
    try {
        YAML::Parser parser(stream);
        while (parser.HandleNextDocument(builder)) {
        }
    } catch (const YAML::Exception& error) {
        const std::string where = error.mark.is_null() ? name : name + ":" + std::to_string(error.mark.line + 1);
        throw Error(where + ": is not YAML: " + printable(error.msg));
    }
    return builder.take();
}

}  // namespace nacre
