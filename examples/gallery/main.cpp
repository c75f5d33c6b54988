// The pictures of docs/gallery.md: every scheme on the same models, and figures of the papers; and that
// of docs/theory/local-refinement.md.
//
//   gallery data/gallery FOLDER            writes FOLDER/*.png
//   gallery --small data/gallery FOLDER    few faces and pixels, for tests

#include <filesystem>
#include <iostream>
#include <string_view>

#include "pictures.h"

namespace {

void write_all(const std::vector<gallery::Picture>& pictures, const gallery::Settings& settings,
               const std::filesystem::path& folder) {
  for (const gallery::Picture& picture : pictures) {
    const std::filesystem::path file = folder / (picture.name + ".png");
    limes::write_png(file, limes::to_image(limes::drawing(picture.grid), settings.density));
    std::cout << file.string() << '\n';
  }
}

}  // namespace

int main(int argc, char** argv) {
  const bool small = argc > 1 && std::string_view(argv[1]) == "--small";
  if (argc != (small ? 4 : 3)) {
    std::cerr << "usage: gallery [--small] MODELS FOLDER\n";
    return 2;
  }
  try {
    const std::filesystem::path folder = argv[argc - 1];
    gallery::Settings settings{.models = argv[argc - 2]};
    if (small) {
      settings.most_faces = 800;
      settings.density = 0.5;
    }
    std::filesystem::create_directories(folder);
    write_all(gallery::scheme_pictures(settings), settings, folder);
    write_all(gallery::velho_pictures(settings), settings, folder);
    write_all(gallery::kobbelt_pictures(settings), settings, folder);
    write_all(gallery::adaptive_pictures(settings), settings, folder);
  } catch (const std::exception& error) {
    std::cerr << "gallery: " << error.what() << '\n';
    return 1;
  }
}
