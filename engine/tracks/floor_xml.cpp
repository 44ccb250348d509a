#include <cmath>
#include <cstddef>
#include <cstring>
#include <string>
#include <utility>

#include "engine/base/text/plain_text.h"
#include "engine/tracks/file_plan.h"
#include "engine/tracks/raw_rows.h"
#include "engine/tracks/text/number_text.h"
#include "engine/tracks/text/xml_text.h"

namespace throng {
namespace {

class FloorReader final : public XmlReader {
 public:
  FloorReader() : XmlReader("export it again") {}

  Result<FilePlan> plan_of(std::string_view text) {
    if (!read(text, true)) return Error{fault()};
    if (plan_.obstacles.empty() && plan_.walls.empty()) return Error{"it has no wall with points; export it again"};
    if (plan_.obstacles.size() == 1 && plan_.walls.empty()) {
      plan_.floors.push_back({std::move(plan_.obstacles.front()), {}});
      plan_.obstacles.clear();
    }
    return std::move(plan_);
  }

 private:
  void open(const char* name, XmlAttributes attributes, std::size_t depth) override {
    if (depth == 0 && std::strcmp(name, "floor") != 0) {
      stop("<" + plain_text(std::string(name).substr(0, 40)) +
           "> is no floor of crowd:it; name a .floor, or walls as WKT");
    } else if (std::strcmp(name, "wall") == 0) {
      const char* const closed = attributes.of("closed");
      is_wall_ = true;
      is_closed_ = closed != nullptr && std::strcmp(closed, "true") == 0;
      points_.clear();
    } else if (is_wall_ && std::strcmp(name, "point") == 0) {
      take_point(attributes);
    }
  }

  void take_point(XmlAttributes attributes) {
    glm::dvec2 point(0.0);
    const auto take = [&](const char* name, double& number) {
      const char* const text = attributes.of(name);
      return text != nullptr && is_number_text(text, number) && std::abs(number) <= most_metres;
    };
    if (!take("x", point.x) || !take("y", point.y)) return stop("a point has no x and y in metres; put them there");
    points_.push_back(point);
  }

  void close(const char* name) override {
    if (std::strcmp(name, "wall") != 0) return;
    is_wall_ = false;
    if (is_closed_ && points_.size() >= 3) {
      plan_.obstacles.push_back(std::move(points_));
    } else if (points_.size() >= 2) {
      plan_.walls.push_back({std::move(points_), {}});
    } else {
      ++plan_.unknown_shapes;
    }
    points_ = {};
  }

  FilePlan plan_;
  FileRing points_;
  bool is_wall_ = false, is_closed_ = false;
};

}  // namespace

Result<FilePlan> parse_floor(std::string_view text) { return FloorReader().plan_of(text); }

}  // namespace throng
