/// @file
/// The pictures that the chapters' programs make, as listed in their pictures.json.
#pragma once

#include <string>
#include <vector>

#include "runner/home.hpp"
#include "runner/json_files.hpp"

namespace lt {

/// The pictures of the chapters, in order; a chapter without pictures.json has none.
/// @throws InputError  a pictures.json is broken
[[nodiscard]] std::vector<Picture> load_pictures(const Home& home,
                                                 const std::vector<std::string>& chapters);

/// What is behind the program's name to make the picture at a size.
/// @param size  for pictures made of pixels; 0 x 0 leaves it to the program
[[nodiscard]] std::vector<std::string> picture_arguments(const Picture& picture, PictureSize size,
                                                         const std::filesystem::path& out);

/// The same as one would type it: "./learn chapter 2 --view normals --out room.png".
[[nodiscard]] std::string picture_command(const Picture& picture, PictureSize size,
                                          const std::string& out);

/// The size for `./learn render`: full, or small for a quick look.
[[nodiscard]] PictureSize render_size(const Picture& picture, bool is_quick);

/// Width and height of a PNG, from its header; 0 x 0 for anything else.
[[nodiscard]] PictureSize png_size(std::string_view bytes);

/// A picture that is to be made, and where.
struct PictureJob {
  Picture picture;
  PictureSize size;
  std::filesystem::path out;
};

/// Runs the programs one after another, with one progress bar.
/// @throws BuildFailed  a program failed or wrote nothing; with what it printed
void make_pictures(const Home& home, const std::vector<PictureJob>& jobs, const std::string& label);

}  // namespace lt
