#include "tests/tools/scene_texts.h"

#include "geometry/numbers/errors.h"

namespace sightline::tests {

cli::SceneDescription scene_of(const std::string& cameras, const FileTexts& files) {
  const auto text_of = [&files](const std::string& path) {
    const auto found = files.find(path);
    if (found == files.end())
      throw InputError(path, 0, "the file of cameras cannot be read: there is none; name one that can be");
    return found->second;
  };
  return cli::parse_scene("[mesh]\nfile = \"a.obj\"\n" + cameras, "dir/scene.toml", text_of);
}

}  // namespace sightline::tests
