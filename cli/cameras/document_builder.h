// Puts a tree together from what a parser meets, one thing after the other, and refuses what goes too deep or is too much.
#pragma once

#include <string>
#include <vector>

#include "cli/cameras/document.h"

namespace sightline::cli {

class DocumentBuilder {
 public:
  explicit DocumentBuilder(const std::string& file) : file_(&file) {}

  void begin(DocumentNode::Kind kind, std::size_t line);
  void end();
  void key(std::string text, std::size_t line);
  void scalar(std::string text, std::size_t line);

  // Whether the next text of a table is a key.
  [[nodiscard]] bool expects_key() const;
  [[nodiscard]] std::size_t depth() const { return open_.size(); }

  // The root; throws where there is none that is a table.
  [[nodiscard]] DocumentNode finished();

 private:
  struct Open {
    DocumentNode node;
    std::string key;
    bool has_key = false;
  };

  void add(DocumentNode node);
  void count(std::size_t line);

  const std::string* file_;
  std::vector<Open> open_;
  std::vector<DocumentNode> roots_;
  std::size_t nodes_ = 0;
};

}  // namespace sightline::cli
