// What clips do beside their poses, said.
#pragma once

#include <string>

#include <nlohmann/json.hpp>

#include "marrow/clip_motion.h"
#include "marrow/file.h"

namespace marrow::tools {

// Members: speed_m_s and heading, null where it goes nowhere; events, phase_marks; root, null where it stays.
nlohmann::ordered_json describe_motion(const File& file, const ClipMotion& motion);

// ", moves at 1.4 m/s, 4 events"; empty of a clip of which nothing is known.
std::string summary_of_motion(const nlohmann::ordered_json& motion);

// All clips of a file's description, their events one a line.
void print_motions(const nlohmann::ordered_json& description);

}  // namespace marrow::tools
