#pragma once

#include <string>
#include <vector>

#include "bench/peers/truth.hpp"
#include "bench/peers/verdict.hpp"

namespace shadefit::side_by_side {

/// The verdicts on the fitting tasks as a Markdown table.
std::string verdict_table(const std::vector<Task>& tasks, const std::vector<Row>& rows);

/// A Markdown table for each task with a result.
std::string task_tables(const std::vector<Task>& tasks, const std::vector<Row>& rows);

}  // namespace shadefit::side_by_side
