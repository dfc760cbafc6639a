/// @file
/// out/index.html: every rendered picture on one page, with the command that makes it.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace lt {

/// One picture of the sheet.
struct SheetPicture {
  std::string chapter;  ///< "2. Ray casting"
  std::string link;     ///< relative to the page: "ch02_ray_casting/room.png"
  std::string title;    ///< may be empty
  std::string caption;
  std::string command;  ///< what one types to make it
  std::string details;  ///< "900 x 720, 312 KB"
};

/// A complete page: needs no other file than the pictures, no script, no network; dark and light.
[[nodiscard]] std::string contact_sheet(const std::vector<SheetPicture>& pictures);

/// Text as HTML shows it literally.
[[nodiscard]] std::string escaped_html(std::string_view text);

}  // namespace lt
