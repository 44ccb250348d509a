// A state machine that is read from a file: it moves by speed, waves when it is greeted, sits when it is tired.
#include <cstdio>
#include <string_view>

#include "throng/throng.h"

using namespace throng;

int main(int count, char** arguments) {
  if (count != 3) return std::fprintf(stderr, "usage: state_machine MODEL MACHINE\n"), 2;
  const auto file = load(arguments[1]);
  if (!file) return std::fprintf(stderr, "%s\n", file.error().message.c_str()), 1;
  const Character person = file->characters.front();
  const auto machine = StateMachine::load(arguments[2], person);
  if (!machine) return std::fprintf(stderr, "%s\n", machine.error().message.c_str()), 1;
  const auto speed = machine->find_input("speed"), greet = machine->find_input("greet"),
             tired = machine->find_input("tired");
  if (!speed || !greet || !tired) return std::fprintf(stderr, "the machine needs speed, greet and tired\n"), 1;

  auto crowd = Crowd::create(person);
  if (!crowd) return std::fprintf(stderr, "%s\n", crowd.error().message.c_str()), 1;
  const Agent agent = crowd->agent(crowd->add_agent());
  const auto body = agent.add(*machine);
  if (!body) return std::fprintf(stderr, "%s\n", body.error().message.c_str()), 1;
  const Machine mind(agent, *body);

  std::string_view shown;
  for (int frame = 0; frame < 1500; ++frame) {
    if (frame == 60) mind.set(*speed, 3.0F);
    if (frame == 300) mind.set(*speed, 0.0F);
    if (frame == 400) mind.fire(*greet);
    if (frame == 600) mind.set(*tired, 1.0F);
    if (frame == 1200) mind.set(*tired, 0.0F);
    crowd->advance(ticks_per_second / 60);
    const PoseRequest pose{.agent = agent.id()};  // no palette: this example does not draw
    crowd->update({&pose, 1});
    const std::string_view name = machine->state_name(mind.state());
    if (name == shown) continue;
    shown = name;
    std::printf("%5.2f s: %.*s\n", to_seconds(mind.entered_at()), static_cast<int>(name.size()), name.data());
  }
}
