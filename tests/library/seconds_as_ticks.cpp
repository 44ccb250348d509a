// Does not compile. A test reads what the compiler says of it.
#include "throng/channels.h"

throng::Play in_a_quarter_second() {
  throng::Play play;
  play.fade = 0.25F;
  return play;
}
