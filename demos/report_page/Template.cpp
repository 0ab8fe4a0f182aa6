#include "demos/report_page/Template.h"

// The bytes of the file CUTWATER_PAGE_TEMPLATE, which the build makes.
asm(".section .rodata\n"
    ".global cutwater_page_begin\n"
    ".global cutwater_page_end\n"
    "cutwater_page_begin:\n"
    ".incbin \"" CUTWATER_PAGE_TEMPLATE
    "\"\n"
    "cutwater_page_end:\n"
    ".byte 0\n"
    ".previous\n");

extern "C" const char cutwater_page_begin[], cutwater_page_end[];

namespace cutwater::page {

std::string_view pageTemplate() {
  std::string_view text(cutwater_page_begin,
                        static_cast<std::size_t>(cutwater_page_end - cutwater_page_begin));
  while (text.ends_with('\n')) text.remove_suffix(1);
  return text;
}

}  // namespace cutwater::page
