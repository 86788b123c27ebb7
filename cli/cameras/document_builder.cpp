#include "cli/cameras/document_builder.h"

#include <fmt/format.h>

#include <algorithm>

#include "formats/reading/printable.h"
#include "geometry/numbers/errors.h"

namespace sightline::cli {

namespace {

void refuse_repeated_keys(const DocumentNode& table, const std::string& file) {
  std::vector<const DocumentMember*> sorted;
  for (const DocumentMember& member : table.members) sorted.push_back(&member);
  std::ranges::stable_sort(sorted, [](const auto* a, const auto* b) { return a->key < b->key; });
  const auto same = std::ranges::adjacent_find(sorted, [](const auto* a, const auto* b) { return a->key == b->key; });
  if (same == sorted.end()) return;
  const DocumentMember& second = **(same + 1);
  throw InputError(file, second.value.line,
                   fmt::format("a second '{}' in one table; remove one of them", printable(second.key)));
}

}  // namespace

void DocumentBuilder::count(std::size_t line) {
  if (++nodes_ > most_nodes)
    throw InputError(*file_, line, fmt::format("more than {} values; divide the file", most_nodes));
}

void DocumentBuilder::begin(DocumentNode::Kind kind, std::size_t line) {
  count(line);
  if (open_.size() >= deepest)
    throw InputError(*file_, line,
                     fmt::format("more than {} levels, and no camera file is so deep; export it again", deepest));
  open_.emplace_back();
  open_.back().node.kind = kind;
  open_.back().node.line = line;
}

void DocumentBuilder::end() {
  DocumentNode node = std::move(open_.back().node);
  open_.pop_back();
  if (node.kind == DocumentNode::Kind::table) refuse_repeated_keys(node, *file_);
  add(std::move(node));
}

bool DocumentBuilder::expects_key() const {
  return !open_.empty() && open_.back().node.kind == DocumentNode::Kind::table && !open_.back().has_key;
}

void DocumentBuilder::key(std::string text, std::size_t line) {
  count(line);
  open_.back().key = std::move(text);
  open_.back().has_key = true;
}

void DocumentBuilder::scalar(std::string text, std::size_t line) {
  count(line);
  DocumentNode node;
  node.text = std::move(text);
  node.line = line;
  add(std::move(node));
}

void DocumentBuilder::add(DocumentNode node) {
  if (open_.empty()) {
    roots_.push_back(std::move(node));
    return;
  }
  Open& parent = open_.back();
  if (parent.node.kind == DocumentNode::Kind::list) {
    parent.node.items.push_back(std::move(node));
    return;
  }
  parent.node.members.push_back({std::move(parent.key), std::move(node)});
  parent.has_key = false;
}

DocumentNode DocumentBuilder::finished() {
  if (roots_.empty()) throw InputError(*file_, 0, "the file is empty; name one with cameras");
  if (roots_.size() > 1) throw InputError(*file_, roots_[1].line, "a second document begins here; divide the file");
  if (roots_[0].kind != DocumentNode::Kind::table)
    throw InputError(*file_, roots_[0].line, "the file is no table of keys and values; name one with cameras");
  return std::move(roots_[0]);
}

}  // namespace sightline::cli
