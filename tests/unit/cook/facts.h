// Tests of the cooker as tables: a document as text, a change to it, and what must come of it, as facts.
//
// A change lists JSON pointers and what shall stand there, in order: `"/nodes/1/scale": [1, 2, 1], "/scenes/-": {}`.
// null takes away; "@/nodes/0" is a copy of that.
//
// Facts are what must be found: `"nodes/#": 3, "nodes/2/name": "tip", "nodes/2/scale ~1e-12": [1, 2, 1]`. "#" counts;
// "~" allows for so much; a text that begins with "…" is a part, a list of such all are; "> 0": more; "!" in front:
// what must be otherwise. Warnings are texts "rule" or "rule /pointer": "warns" lists some, "warns only" all, "warns
// not" some that must be missing. A failure stands for itself: `invalid /nodes/1: node loop … did you mean`, its code,
// its place, a part of its rule, and behind "…" parts of all that is said. In both P is meshes/0/primitives/0.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <functional>
#include <string>
#include <utility>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "common/failure.h"

namespace marrow::cook {

using Json = nlohmann::json;

// A document, a change to it and what must come of that. The name is printed where it does not.
struct Row {
  std::string name, change, facts;
};

inline std::string with_long_paths(std::string text) {
  const std::string primitive = "meshes/0/primitives/0";
  for (std::size_t at = 0; (at = text.find('P', at)) != std::string::npos; ++at) {
    const char before = at > 0 ? text[at - 1] : ' ', behind = at + 1 < text.size() ? text[at + 1] : '"';
    if ((before == '/' || before == '"') && (behind == '/' || behind == '"' || behind == ':'))
      text.replace(at, 1, primitive);
  }
  return text;
}

// Members of an object, in their order; one that stands there twice would be lost.
inline nlohmann::ordered_json members(const std::string& text) {
  std::size_t keys = 0;
  auto out = nlohmann::ordered_json::parse("{" + with_long_paths(text) + "}", [&](int depth, auto event, const auto&) {
    keys += depth == 1 && event == nlohmann::ordered_json::parse_event_t::key;
    return true;
  });
  EXPECT_EQ(out.size(), keys) << "a name twice: " << text;
  return out;
}

inline void change_json(Json& root, const std::string& change) {
  const auto changes = members(change);
  for (const auto& [pointer, value] : changes.items()) {
    const Json::json_pointer at(pointer);
    if (value.is_null()) {
      Json& above = root.at(at.parent_pointer());
      if (above.is_array()) {
        above.erase(std::stoul(at.back()));
      } else {
        EXPECT_EQ(above.erase(at.back()), 1U) << "nothing to take away: " << pointer;
      }
    } else if (value.is_string() && value.template get<std::string>().starts_with("@/")) {
      const Json copy = root.at(Json::json_pointer(value.template get<std::string>().substr(1)));
      root[at] = copy;
    } else {
      root[at] = Json::parse(value.dump());
    }
  }
}

// Exactly, of 32-bit floats too, which a text gives in other digits.
inline bool is_number(const Json& found, double want, double tolerance) {
  if (!found.is_number()) return false;
  const double is = found.get<double>();
  return std::abs(is - want) <= tolerance || is == want || is == static_cast<double>(static_cast<float>(want));
}

// Of an object what is asked for, of everything else all.
inline bool is_fact(const Json& found, const Json& want, double tolerance) {
  if (want.is_number()) return is_number(found, want.get<double>(), tolerance);
  if (want.is_string() && want.get<std::string>().starts_with("> "))
    return found.is_number() && found.get<double>() > std::strtod(want.get<std::string>().c_str() + 2, nullptr);
  if (want.is_string() && want.get<std::string>().starts_with("…"))
    return found.is_string() && found.get<std::string>().find(want.get<std::string>().substr(3)) != std::string::npos;
  if (want.is_array() && found.is_string())  // all parts of it
    return std::ranges::all_of(want, [&](const Json& part) { return is_fact(found, part, tolerance); });
  if (want.is_array())
    return found.is_array() && std::equal(found.begin(), found.end(), want.begin(), want.end(),
                                          [&](const Json& f, const Json& w) { return is_fact(f, w, tolerance); });
  if (want.is_object() && found.is_object())
    return std::all_of(want.items().begin(), want.items().end(), [&](const auto& member) {
      return found.contains(member.key()) && is_fact(found[member.key()], member.value(), tolerance);
    });
  return found == want;
}

// What stands at a path; null where nothing does.
inline Json found_at(const Json& found, const std::string& path) {
  const Json* at = &found;
  for (std::size_t begin = 0; begin <= path.size();) {
    const std::size_t end = std::min(path.find('/', begin), path.size());
    const std::string name = path.substr(begin, end - begin);
    begin = end + 1;
    if (name == "#") return at->size();
    const bool is_there = at->is_array() ? !name.empty() && name.find_first_not_of("0123456789") == std::string::npos &&
                                               std::stoul(name) < at->size()
                                         : at->is_object() && at->contains(name);
    if (!is_there) return nullptr;
    at = at->is_array() ? &(*at)[std::stoul(name)] : &(*at)[name];
  }
  return *at;
}

// found["warnings"]: texts "rule /pointer".
inline void expect_warnings(const Json& found, const std::string& how, const Json& wanted) {
  const Json& all = found.at("warnings");
  for (const Json& want : wanted) {
    const std::string text = want.get<std::string>();
    const bool is_said = std::ranges::any_of(all, [&](const Json& one) {
      const std::string said = one.get<std::string>();
      return said == text || (text.find(' ') == std::string::npos && said.starts_with(text + " "));
    });
    EXPECT_EQ(is_said, how != "warns not") << text << " in " << all.dump();
  }
  if (how == "warns only") EXPECT_EQ(all.size(), wanted.size()) << all.dump();
}

inline void expect_facts(const Json& found, const std::string& facts) {
  const auto wanted = members(facts);
  for (const auto& [key, value] : wanted.items()) {
    const Json want = Json::parse(value.dump());
    if (key.starts_with("warns")) {
      expect_warnings(found, key, want);
      continue;
    }
    const bool is_not = key.starts_with("!");
    const std::size_t tolerance = std::min(key.find(" ~"), key.size());
    const double within = tolerance < key.size() ? std::strtod(key.c_str() + tolerance + 2, nullptr) : 0;
    const Json is = found_at(found, key.substr(is_not ? 1 : 0, tolerance - (is_not ? 1 : 0)));
    EXPECT_NE(is_fact(is, want, within), is_not) << key << ": " << want.dump() << "\nfound: " << is.dump();
  }
}

inline const char* name_of(tools::Exit code) {
  switch (code) {
    case tools::Exit::usage:
      return "usage";
    case tools::Exit::io:
      return "io";
    case tools::Exit::invalid:
      return "invalid";
    case tools::Exit::unsupported:
      return "unsupported";
    default:
      return "another";
  }
}

inline void expect_said(const tools::Failure& failure, const std::string& text) {
  const std::string wanted = with_long_paths(text);
  const std::size_t space = wanted.find(' '), colon = wanted.find(": ", space);
  ASSERT_NE(colon, std::string::npos) << wanted;
  EXPECT_EQ(name_of(failure.code()), wanted.substr(0, space)) << failure.what();
  EXPECT_EQ(failure.where(), wanted.substr(space + 1, colon - space - 1)) << failure.what();
  EXPECT_FALSE(failure.advice().empty()) << failure.what();
  const std::string parts = wanted.substr(colon + 2), mark = " … ";
  const std::size_t end = std::min(parts.find(mark), parts.size());
  EXPECT_NE(failure.rule().find(parts.substr(0, end)), std::string::npos) << failure.what() << "\nwanted: " << wanted;
  for (std::size_t at = end; at < parts.size();) {
    const std::size_t begin = at + mark.size();
    at = std::min(parts.find(mark, begin), parts.size());
    EXPECT_NE(std::string(failure.what()).find(parts.substr(begin, at - begin)), std::string::npos) << failure.what();
  }
}

// What `action` finds, or how it fails.
inline void expect_outcome(const std::function<Json()>& action, const std::string& facts) {
  const bool fails = !facts.empty() && std::isalpha(static_cast<unsigned char>(facts[0])) != 0;
  try {
    const Json found = action();
    if (fails) {
      ADD_FAILURE() << "must fail: " << facts;
    } else {
      expect_facts(found, facts);
    }
  } catch (const tools::Failure& failure) {
    if (fails) {
      expect_said(failure, facts);
    } else {
      ADD_FAILURE() << failure.what();
    }
  }
}

}  // namespace marrow::cook
