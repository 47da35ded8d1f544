#include "problems/resolved_document.hpp"

#include <yaml-cpp/yaml.h>

namespace rfm {
namespace {

// Maps are written line by line down to this depth, and in braces below it.
constexpr int deepest_block = 2;

void emit(YAML::Emitter& emitter, const DocumentNode& node, int depth) {
  switch (node.kind) {
    case DocumentNode::Kind::empty:
      emitter << YAML::Null;
      break;
    case DocumentNode::Kind::scalar:
      if (node.quoted) emitter << YAML::DoubleQuoted;
      emitter << node.text;
      break;
    case DocumentNode::Kind::list: {
      const bool is_flow = depth > deepest_block || node.items.empty() || node.items[0].is_scalar();
      emitter << (is_flow ? YAML::Flow : YAML::Block) << YAML::BeginSeq;
      for (const DocumentNode& item : node.items) emit(emitter, item, deepest_block + 1);
      emitter << YAML::EndSeq;
      break;
    }
    case DocumentNode::Kind::map:
      emitter << (depth > deepest_block || node.entries.empty() ? YAML::Flow : YAML::Block)
              << YAML::BeginMap;
      for (const DocumentNode::Entry& entry : node.entries) {
        emitter << YAML::Key << entry.key << YAML::Value;
        emit(emitter, entry.value, depth + 1);
      }
      emitter << YAML::EndMap;
      break;
  }
}

}  // namespace

std::string document_text(const DocumentNode& root) {
  YAML::Emitter emitter;
  emit(emitter, root, 0);
  return std::string(emitter.c_str()) + "\n";
}

}  // namespace rfm
