#include "pipeline/json.h"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <utility>

namespace nacre {

// The only place that knows nlohmann's library: its headers take a second to compile.
struct JsonWriter {
    static nlohmann::ordered_json written(const Json& json) {
        switch (json.kind_) {
            case Json::Kind::null:
                break;
            case Json::Kind::boolean:
                return json.whole_ != 0;
            case Json::Kind::whole:
                return json.whole_;
            case Json::Kind::real:
                return json.real_;
            case Json::Kind::text:
                return json.text_;
            case Json::Kind::array: {
                nlohmann::ordered_json list = nlohmann::ordered_json::array();
                for (const Json& item : json.items_) list.push_back(written(item));
                return list;
            }
            case Json::Kind::object: {
                nlohmann::ordered_json object = nlohmann::ordered_json::object();
                for (std::size_t i = 0; i < json.items_.size(); ++i)
                    object.push_back({json.names_[i], written(json.items_[i])});
                return object;
            }
        }
        return nullptr;
    }
};

Json::Json(bool value) : kind_(Kind::boolean), whole_(value ? 1 : 0) {}
Json::Json(double value) : kind_(Kind::real), real_(value) {}
Json::Json(const char* text) : kind_(Kind::text), text_(text) {}
Json::Json(std::string_view text) : kind_(Kind::text), text_(text) {}
Json::Json(const std::string& text) : kind_(Kind::text), text_(text) {}

Json::Json(std::initializer_list<JsonMember> members) : kind_(Kind::object) {
    for (const JsonMember& member : members) {
        names_.emplace_back(member.name);
        items_.push_back(member.value);
    }
}

Json Json::array(std::initializer_list<Json> items) {
    Json list(Kind::array);
    list.items_ = items;
    return list;
}

Json& Json::operator[](std::string_view name) {
    if (kind_ == Kind::null) kind_ = Kind::object;
    const auto found = std::find(names_.begin(), names_.end(), name);
    if (found != names_.end()) return items_[static_cast<std::size_t>(found - names_.begin())];
    names_.emplace_back(name);
    return items_.emplace_back();
}

void Json::push_back(Json item) {
    if (kind_ == Kind::null) kind_ = Kind::array;
    items_.push_back(std::move(item));
}

std::string Json::text() const {
    return JsonWriter::written(*this).dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace);
}

}  // namespace nacre
