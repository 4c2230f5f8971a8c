// What became of one input, and how a batch says it.
#pragma once

#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "common/failure.h"
#include "cook/scene/raw.h"
#include "jobs/batch.h"

namespace marrow::tools {

struct Outcome {
  Exit code = Exit::done;
  std::string failure;  // one line that names the input
  nlohmann::ordered_json report;
  std::vector<cook::Read> reads;
  double seconds = 0;
  double cooking_s = 0;  // the same where it was cooked, now or before
  bool from_cache = false;
};

// As a file and on stdout; names need not be UTF-8, the report says what it can.
std::string report_text(const nlohmann::ordered_json& report);

// {source {file}, error {code, text}} of a failure, else the report; and `run`: by which program, how long it took, and
// how many files the command has, all its shards together.
nlohmann::ordered_json report_of(const CookJob& job, const Outcome& outcome, std::size_t files);

// One line about a single file, and a table of many; on stdout.
void print_summary(const CookJob& job, const Outcome& outcome);
void print_table(const std::vector<CookJob>& jobs, const std::vector<Outcome>& outcomes, double seconds);

// Warnings about one input, a line a rule; on stderr.
void print_warnings(const CookJob& job, const Outcome& outcome);

}  // namespace marrow::tools
