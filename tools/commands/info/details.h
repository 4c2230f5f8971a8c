// What `marrow info` says of graphs of behaviour, looks and nodes, joints' roles, and what clips do.
#pragma once

#include <string>

#include <nlohmann/json.hpp>

#include "common/load_mrw.h"
#include "marrow/clip_motion.h"
#include "marrow/file.h"

namespace marrow::tools {

// Adds "graphs": name, bytes, nodes, parameters with their kinds and ranges, clips that are wanted and whether the file
// has them. Throws Failure (invalid) if one is damaged.
void describe_graphs(const std::string& path, const LoadedFile& loaded, nlohmann::ordered_json& description);

// The same as lines of text.
void print_graphs(const nlohmann::ordered_json& description);

// Adds "materials" and "images"; "nodes" with their properties.
void describe_looks(const File& file, nlohmann::ordered_json& description);
void describe_nodes(const File& file, nlohmann::ordered_json& description);

// The same as lines of text.
void print_looks(const nlohmann::ordered_json& description);
void print_nodes(const nlohmann::ordered_json& description);

// {"roles": [{"role", "joint"}], "missing": [role], "pairs": [[left, right]], "soles": [{"joint", "place"}]}, joints by
// name. Missing are roles but tail that no joint has, none of them where no role is known.
nlohmann::ordered_json describe_roles(const File& file, std::uint32_t skeleton);

// "52 joints with roles, 24 pairs, 2 soles"; empty where no role is known.
std::string summary_of_roles(const nlohmann::ordered_json& roles);

// All of it, of each skeleton of a description.
void print_roles(const nlohmann::ordered_json& description);

// Members: speed_m_s and heading, null where it goes nowhere; events, phase_marks; root, null where it stays.
nlohmann::ordered_json describe_motion(const File& file, const ClipMotion& motion);

// ", moves at 1.4 m/s, 4 events"; empty of a clip of which nothing is known.
std::string summary_of_motion(const nlohmann::ordered_json& motion);

// All clips of a file's description, their events one a line.
void print_motions(const nlohmann::ordered_json& description);

}  // namespace marrow::tools
