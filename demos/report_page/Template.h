#pragma once
#include <string_view>

namespace cutwater::page {

/// The page without its data, as web/ was bundled when this program was built; or, if it could not
/// be, the reason in one line.
std::string_view pageTemplate();

}  // namespace cutwater::page
