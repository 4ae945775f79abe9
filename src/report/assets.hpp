// The page's fixed parts, embedded at build time from src/report/page/ and from D3 (BSD-3).
#pragma once
#include <string_view>

namespace pmr::report {

std::string_view asset_frame();   // report.html
std::string_view asset_style();   // report.css
std::string_view asset_script();  // all of our scripts, in order
std::string_view asset_d3();      // d3.min.js

}  // namespace pmr::report
