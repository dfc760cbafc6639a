/// @file
/// What the program does with its options: render, save after every pass, sum up.
#pragma once

#include <cstdio>
#include <filesystem>
#include <iostream>

#include "ch01_pixels/image_file.hpp"
#include "ch05_rendering_equation/plots.hpp"
#include "ch05_rendering_equation/views.hpp"
#include "common/command_line.hpp"
#include "common/files.hpp"
#include "common/timing.hpp"

namespace lt {

/// Says which views and plots use which options; these must have been added.
inline void restrict_lit_options(CommandLine& line) {
  for (const char* of_pictures : {"--view", "--camera", "--spp"})
    line.only_for(of_pictures, "--plot", {"none"});
  for (const char* of_room : {"--depth", "--wrong", "--texels", "--threads"})
    line.only_for(of_room, "--plot", {"none", "noise"});
  for (const char* of_far_and_near : {"--camera", "--spp"})  // the strip has its own
    line.only_for(of_far_and_near, "--view", {"room"});
}

/// The picture's seed and threads, for render().
[[nodiscard]] inline SampleRange range_for(const RenderOptions& picture) {
  return {.seed = picture.seed, .threads = picture.threads};
}

/// The same with all of the picture's samples, for a picture that is rendered in one go.
[[nodiscard]] inline SampleRange whole_range_for(const RenderOptions& picture) {
  SampleRange range = range_for(picture);
  range.last = picture.samples_per_pixel;
  return range;
}

/// One line: how many samples every pixel has, and how noisy it still is.
inline void print_pass(const Film& before, const Film& film) {
  const FilmSummary counts = summary(film);
  std::cout << counts.least;
  if (counts.most > counts.least) std::cout << " to " << counts.most;
  std::cout << " samples per pixel";
  if (const auto found = pixel_noise(before, film)) {
    char text[40];
    std::snprintf(text, sizeof text, ", noise %.4f W/(m^2 sr)", *found);
    std::cout << text;
  }
  std::cout << '\n' << std::flush;
}

/// One line: how many paths, and how many in a second of processor time.
inline void print_speed(const Film& film, const ProcessorTimer& timer) {
  const auto paths = static_cast<double>(summary(film).total);
  const double seconds = timer.seconds();
  char text[120];
  std::snprintf(text, sizeof text,
                "%.2f million paths in %.1f s of processor time: %.2f million a second",
                paths * 1e-6, seconds, paths * 1e-6 / std::max(seconds, 1e-3));
  std::cout << text << '\n';
}

/// The file that a program writes: the one that it was told, otherwise one named after the plot,
/// or after the view if `plot` is "none".
/// @throws InputError  its name does not end like a picture's: known before the work, not after it
[[nodiscard]] inline std::filesystem::path output_path(const RenderOptions& picture,
                                                       const std::string& view,
                                                       const std::string& plot) {
  const bool is_plot = plot != "none";
  std::filesystem::path out = picture.out;
  if (out.empty()) out = is_plot ? plot + ".svg" : view + ".png";
  if (!is_plot) require_picture_path(out);
  return out;
}

/// The last words of a program.
/// @param is_written  false where a run that is stopped leaves no file
inline void print_outcome(const std::filesystem::path& out, bool is_stopped, bool is_written) {
  if (is_stopped) std::cout << "stopped early\n";
  if (is_written) std::cout << "wrote " << printable(out.string()) << '\n';
}

// [render-to-file]
/// Renders in passes; after each, the file holds the picture so far. When `cancel` is set, the
/// samples that there are make the picture.
/// @throws std::runtime_error  a sample was negative, infinite or NaN; the picture is written
/// @throws OutputError         the file cannot be written
template <RadianceEstimator Estimator>
void render_to_file(const Estimator& estimate, const Camera& camera, const RenderOptions& picture,
                    const std::filesystem::path& out, const std::atomic<bool>& cancel) {
  const auto& [width, height, spp, seed, threads, ignored] = picture;
  Film film(width, height);
  save_image(out, developed(film));  // a place that cannot be written is told before the work
  Progress progress(out.stem().string(), std::int64_t{width} * height * spp);

  const ProcessorTimer timer;
  const auto after_pass = [&](const Film& before, const Film& so_far) {
    save_image(out, developed(so_far));
    print_pass(before, so_far);
  };
  render_in_passes(film, camera, estimate, spp, range_for(picture), cancel, after_pass, &progress);
  print_speed(film, timer);
  require_good_samples(film);
}
// [render-to-file]

// [write-room]
/// Renders the room to a file, which holds the picture so far after every pass.
inline void write_room(const LitViewOptions& show, const RenderOptions& picture,
                       const std::filesystem::path& out, const std::atomic<bool>& cancel) {
  const TexturedScene scene = matt_room(show.texels);
  render_to_file(estimator_for(show.wrong, scene, show.depth), camera_named(show.camera), picture,
                 out, cancel);
}
// [write-room]

/// Writes the strip.
inline void write_strip(const LitViewOptions& show, const RenderOptions& picture,
                        const std::filesystem::path& out, const std::atomic<bool>& cancel) {
  const TexturedScene scene = matt_room(show.texels);
  const AnyEstimator estimate = estimator_for(show.wrong, scene, show.depth);
  save_image(out, strip(estimate, picture.width, picture.height, range_for(picture), cancel));
}

/// The noise of the close-up, measured and drawn.
[[nodiscard]] inline Plot measured_noise_plot(const LitViewOptions& show,
                                              const RenderOptions& picture,
                                              const std::atomic<bool>& cancel) {
  const TexturedScene scene = matt_room(show.texels);
  const std::vector<NoiseAt> measured =
      measure_noise(close_up_camera(), estimator_for(show.wrong, scene, show.depth), 96, 72, 128,
                    range_for(picture), cancel);
  for (const NoiseAt& at : measured)
    std::cout << at.samples << " samples per pixel: noise " << at.noise << " W/(m^2 sr)\n";
  return cancel ? Plot{} : noise_plot(measured);  // half a plot is none
}

/// Draws the plot `name` (noise or furnace).
/// @throws InputError  `out` is no .svg
inline void write_plot(const std::string& name, const LitViewOptions& show,
                       const RenderOptions& picture, const std::filesystem::path& out,
                       const std::atomic<bool>& cancel) {
  require_plot_path(out);
  const Plot plot = name == "noise" ? measured_noise_plot(show, picture, cancel)
                                    : furnace_plot(20'000, picture.seed);
  if (!cancel) write_file_whole(out, to_svg(plot));
}

}  // namespace lt
