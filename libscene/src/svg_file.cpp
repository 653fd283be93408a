// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#include "svg_file.hpp"

#include <algorithm>
#include <array>
#include <unordered_map>

#include "message_text.hpp"
#include "object_reader.hpp"
#include "svg_shapes.hpp"
#include "svg_values.hpp"
#include "svg_viewport.hpp"
#include "text_file.hpp"

namespace sweepkit::scene {
namespace {

constexpr int kDeepest = 256;  // drawing programs nest some twenty groups

// A use element that holds others doubles the work with each level.
constexpr int kMostElements = 1'000'000;
constexpr std::size_t kMostRead = 4 * kLargestSvg;  // bytes of coordinates: a second or two

// What an element has from those about it.
struct Context {
  glm::dmat3 document_from_user{1.0};
  Viewport viewport;
  FillRule rule = FillRule::kNonzero;
  bool is_filled = true;
  bool is_visible = true;
  int depth = 0;
};

bool is_any_of(std::string_view word, std::initializer_list<std::string_view> words) {
  return std::find(words.begin(), words.end(), word) != words.end();
}

class Drawing {
 public:
  Drawing(const pugi::xml_document& document, const SvgSource& source)
      : root_(document.document_element(), source) {
    for (pugi::xml_node node = root_.node(); node; node = after(node)) {
      if (const pugi::xml_attribute id = node.attribute("id")) by_id_.emplace(id.value(), node);
      if (root_.at(node).kind() == "style") check_style_sheet(root_.at(node));
    }
  }

  std::vector<DrawnShape> all() {
    Context context;
    context.document_from_user = {{1, 0, 0}, {0, -1, 0}, {0, 0, 1}};  // y upwards
    draw(root_, context);
    return std::move(shapes_);
  }

  std::vector<DrawnShape> only(const std::string& id) {
    const auto found = by_id_.find(id);
    if (found == by_id_.end()) root_.fail(unknown_id(id));
    std::vector<pugi::xml_node> line = {found->second};
    while (line.back() != root_.node()) line.push_back(line.back().parent());
    Context context;
    context.document_from_user = {{1, 0, 0}, {0, -1, 0}, {0, 0, 1}};
    for (std::size_t i = line.size(); i-- > 1;) context = inside(root_.at(line[i]), context);
    draw_content(root_.at(line.front()), context, true);
    return std::move(shapes_);
  }

 private:
  // The next element in the document's order, without recursion.
  pugi::xml_node after(pugi::xml_node node) const {
    if (node.first_child()) return node.first_child();
    while (node != root_.node() && !node.next_sibling()) node = node.parent();
    return node == root_.node() ? pugi::xml_node() : node.next_sibling();
  }

  static void check_style_sheet(const SvgElement& element) {
    std::string text;
    for (const pugi::xml_node& child : element.node().children()) text += child.value();
    std::erase_if(text, [](char c) { return c == ' ' || c == '\t' || c == '\r' || c == '\n'; });
    for (const char* word : {"fill:none", "fill-rule", "display:", "visibility:", "transform"}) {
      if (text.find(word) != std::string::npos) {
        element.fail("style sheets are not read, and this one says " + in_quotes(word) +
                     "; put it into the elements' attributes");
      }
    }
  }

  std::string unknown_id(const std::string& id) const {
    std::vector<std::string> ids;
    ids.reserve(by_id_.size());
    for (const auto& [known, node] : by_id_) ids.emplace_back(known);
    std::sort(ids.begin(), ids.end());
    if (ids.empty()) return "there is no element " + in_quotes(id) + ": none has an id; leave \"id\" out";
    return unknown_name("element", id, ids);
  }

  // The context of what is in the element, but for its viewport.
  static Context styled(const SvgElement& element, Context context) {
    if (++context.depth > kDeepest) {
      element.fail("is nested deeper than " + std::to_string(kDeepest) +
                   " elements; a use element may not hold itself");
    }
    if (const auto rule = element.property("fill-rule"); rule && *rule != "inherit") {
      if (!is_any_of(*rule, {"nonzero", "evenodd"})) {
        element.fail("\"fill-rule\" needs nonzero or evenodd, got " + in_quotes(*rule));
      }
      context.rule = *rule == "evenodd" ? FillRule::kEvenOdd : FillRule::kNonzero;
    }
    if (const auto fill = element.property("fill"); fill && *fill != "inherit") {
      context.is_filled = *fill != "none";
    }
    if (const auto visibility = element.property("visibility"); visibility && *visibility != "inherit") {
      context.is_visible = *visibility == "visible";
    }
    if (const auto text = element.attribute("transform")) {
      try {
        context.document_from_user = context.document_from_user * read_transform(*text);
      } catch (const InputError& error) {
        element.fail("\"transform\" " + error.problem());
      }
    }
    const bool is_styled = element.property("transform") != element.attribute("transform");
    if (is_styled || element.property("transform-origin")) {
      element.fail("CSS transforms are not read; put a transform attribute in their place");
    }
    return context;
  }

  static void enter(const InnerSpace& space, Context& context) {
    context.document_from_user = context.document_from_user * space.outer_from_inner;
    context.viewport = space.viewport;
  }

  Context inside(const SvgElement& element, const Context& outer) const {
    Context context = styled(element, outer);
    if (element.node() == root_.node()) {
      enter(outermost_space(element), context);
    } else if (element.kind() == "svg") {
      enter(nested_space(element, context.viewport, nullptr), context);
    }
    return context;
  }

  void draw(const SvgElement& element, const Context& outer) {
    if (element.property("display") != "none") draw_content(element, outer, false);
  }

  // What is never drawn by itself (a symbol, defs) is when it was chosen.
  void draw_content(const SvgElement& element, const Context& outer, bool is_chosen) {
    if (++elements_ > kMostElements) {
      element.fail("draws more than " + std::to_string(kMostElements) + " elements; simplify the drawing");
    }
    const std::string_view kind = element.kind();
    const auto entered = [&] {
      Context context = inside(element, outer);
      context.is_visible |= is_chosen;
      return context;
    };
    if (is_shape(kind)) {
      add(element, entered());
    } else if (kind == "use") {
      draw_use(element, entered());
    } else if (is_any_of(kind, {"svg", "g", "a", "switch"}) ||
               (is_chosen && is_any_of(kind, {"defs", "symbol", "clipPath", "mask", "marker", "pattern"}))) {
      draw_children(element, entered());
    } else if (is_chosen) {
      element.fail("has no outlines; convert it to a path, or choose another element");
    }
  }

  void draw_children(const SvgElement& element, const Context& context) {
    for (const pugi::xml_node& child : element.node().children()) draw(element.at(child), context);
  }

  void draw_use(const SvgElement& use, Context context) {
    const std::string_view name =
        use.attribute("href") ? *use.attribute("href") : use.attribute("xlink:href").value_or("");
    if (!name.starts_with('#')) {
      use.fail("\"href\" needs an element of this file (\"#...\"), got " + in_quotes(name));
    }
    const auto found = by_id_.find(name.substr(1));
    if (found == by_id_.end()) use.fail(unknown_id(std::string(name.substr(1))));
    const SvgElement target = use.at(found->second);
    const glm::dvec2 corner(use.length("x", context.viewport, Along::kWidth).value_or(0),
                            use.length("y", context.viewport, Along::kHeight).value_or(0));
    context.document_from_user =
        context.document_from_user * glm::dmat3({1, 0, 0}, {0, 1, 0}, {corner.x, corner.y, 1});
    const bool is_root = target.node() == root_.node();
    if (is_root) use.fail("holds itself: it uses the document's own svg element; use a part of it");
    if (!is_any_of(target.kind(), {"symbol", "svg"})) return draw(target, context);
    if (target.property("display") == "none") return;
    Context inner = styled(target, context);
    enter(nested_space(target, context.viewport, &use), inner);
    draw_children(target, inner);
  }

  void add(const SvgElement& element, const Context& context) {
    if (!context.is_visible) return;
    read_ += element.attribute("d").value_or("").size() + element.attribute("points").value_or("").size();
    if (read_ > kMostRead) element.fail("is drawn too often by use elements; simplify the drawing");
    OutlineBuilder pen;
    draw_shape(element, context.viewport, pen);
    DrawnShape shape{.outlines = pen.take(),
                     .rule = context.rule,
                     .is_filled = context.is_filled && element.kind() != "line"};
    for (Outline& outline : shape.outlines) {
      segments_ += outline.segments.size();
      transform(outline, context.document_from_user);
    }
    if (segments_ > kMostSegments) {
      element.fail("the drawing has more than " + std::to_string(kMostSegments) +
                   " segments up to here; simplify it, or choose an element by \"id\"");
    }
    if (!shape.outlines.empty()) shapes_.push_back(std::move(shape));
  }

  SvgElement root_;
  std::unordered_map<std::string_view, pugi::xml_node> by_id_;
  std::vector<DrawnShape> shapes_;
  int elements_ = 0;
  std::size_t segments_ = 0;
  std::size_t read_ = 0;
};

}  // namespace

std::vector<DrawnShape> read_svg(const std::string& text, const std::string& file,
                                 const std::optional<std::string>& id) {
  pugi::xml_document document;
  const pugi::xml_parse_result result = document.load_buffer(text.data(), text.size());
  SvgSource source{.text = text, .file = file, .has_offsets = result.encoding == pugi::encoding_utf8};
  if (!result) {
    const Place place =
        source.has_offsets
            ? place_in(text, static_cast<std::size_t>(std::max<std::ptrdiff_t>(result.offset, 0)), file)
            : Place{.file = file};
    throw InputError(place, std::string("not valid XML: ") + result.description());
  }
  const std::string name = document.document_element().name();
  source.prefix = name.substr(0, name.find(':') + 1);  // npos + 1 is 0
  const SvgElement root(document.document_element(), source);
  if (root.kind() != "svg") root.fail("needs to be an svg element, for this to be an SVG file");
  Drawing drawing(document, source);
  return id ? drawing.only(*id) : drawing.all();
}

}  // namespace sweepkit::scene
