#pragma once

#include <array>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <string>
#include <string_view>
#include <vector>

namespace nacre {

struct JsonMember;

/// A JSON value that is built piece by piece. The members of an object keep their order.
class Json {
public:
    /// null
    Json() = default;
    Json(std::nullptr_t) {}
    Json(bool value);
    Json(double value);
    template <std::integral Integer>
    Json(Integer value) : Json(static_cast<std::int64_t>(value), Whole{}) {}
    Json(const char* text);
    Json(std::string_view text);
    Json(const std::string& text);
    template <typename Item>
    Json(const std::vector<Item>& items) : kind_(Kind::array), items_(items.begin(), items.end()) {}
    template <typename Item, std::size_t count>
    Json(const std::array<Item, count>& items) : kind_(Kind::array), items_(items.begin(), items.end()) {}
    /// An object: `{{"width", 256}, {"format", "half"}}`.
    Json(std::initializer_list<JsonMember> members);

    static Json array() { return Json(Kind::array); }
    static Json array(std::initializer_list<Json> items);
    static Json object() { return Json(Kind::object); }

    /// The member of that name; added, as null, if it is not there. null becomes an object.
    Json& operator[](std::string_view name);
    /// Adds an item. null becomes an array.
    void push_back(Json item);
    /// The last item. @pre there is one
    Json& back() { return items_.back(); }
    /// Items of an array, members of an object.
    std::size_t size() const { return items_.size(); }

    /// Indented by two blanks. Bytes that are not UTF-8 (file names may hold them) become U+FFFD; numbers that are not
    /// finite become null.
    std::string text() const;

private:
    enum class Kind { null, boolean, whole, real, text, array, object };
    struct Whole {};
    friend struct JsonWriter;

    explicit Json(Kind kind) : kind_(kind) {}
    Json(std::int64_t value, Whole) : kind_(Kind::whole), whole_(value) {}

    Kind kind_ = Kind::null;
    std::int64_t whole_ = 0;  // booleans too
    double real_ = 0.0;
    std::string text_;
    std::vector<std::string> names_;  // of an object, as many as items
    std::vector<Json> items_;
};

struct JsonMember {
    std::string_view name;
    Json value;
};

}  // namespace nacre
