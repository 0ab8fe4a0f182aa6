#pragma once
#include <string>
#include <vector>

namespace cutwater::page {

/// All of the page's data as JSON: a database and what was run with it.
/// @throws HydroError naming file, field and value.
std::string pageData(const std::string& database, const std::vector<std::string>& runs);

/// The page with this data in it.
/// @throws HydroError where this program was built without the page's scripts, with the reason.
std::string pageWith(const std::string& data);
/// Throws as pageWith, before any work.
void requirePage();

}  // namespace cutwater::page
