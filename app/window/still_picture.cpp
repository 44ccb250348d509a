#include "app/window/still_picture.h"

#include "app/output/regression/origin.h"
#include "app/show/painter.h"
#include "app/show/show.h"
#include "app/show/show_view.h"
#include "app/show/stage/stage.h"

namespace throng::app {
namespace {

/// Gives a show back its window's picture, and the values of before.
class ShownBefore {
 public:
  explicit ShownBefore(Show& show)
      : show_(show),
        tuning_(show.stage().tuning()),
        window_(show.painter().renderer().size()),
        drawn_(show.view().width, show.view().height),
        free_(show.view().free) {}

  Status give_back() const {
    ShowView& view = show_.view();
    view.width = drawn_.x;
    view.height = drawn_.y;
    view.free = free_;
    const Status sized = show_.painter().renderer().set_size(window_, drawn_);
    const Status valued = tuning_ == show_.stage().tuning() ? Done{} : show_.take(Apply{tuning_});
    return sized ? valued : sized;
  }

 private:
  Show& show_;
  Tuning tuning_;
  glm::ivec2 window_, drawn_;
  PicturePart free_;
};

/// Poses the crowd for a picture of the view's size. It stands still, so that new values pose all agents at once.
Status pose_with(Show& show, const Tuning& values) {
  show.animate(Ticks{});
  if (Status applied = show.take(Apply{values}); !applied) return applied;
  show.animate(Ticks{});
  return Done{};
}

}  // namespace

Status write_picture(Show& show, const std::string& file) {
  Painter& painter = show.painter();
  const render::Image& image = painter.renderer().read_image();
  if (Status read = painter.renderer().finish(); !read) return read;
  return render::write_png(image, file, origin_texts(painter.drawn_by()));
}

glm::ivec2 size_of_still(Show& show, int times) { return times * show.painter().renderer().size(); }

Status write_still(Show& show, const std::string& file, glm::ivec2 size, const Tuning& values, bool is_replay,
                   const std::function<Status(Show&)>& draw_over) {
  const ShownBefore before(show);
  if (Status sized = show.painter().set_still(size); !sized) return sized;
  ShowView& view = show.view();
  view.width = size.x;
  view.height = size.y;
  view.free = {};
  Status written = is_replay ? Done{} : pose_with(show, values);
  if (written) written = show.draw();
  if (written) written = draw_over(show);
  if (written) written = write_picture(show, file);
  const Status back = before.give_back();
  return written ? back : written;
}

}  // namespace throng::app
