// SPDX-License-Identifier: BSD-3-Clause
// A servo loop of another program, without VTK: 1 kHz, its own clock, step(sample, time) in the
// middle. ServoScene.h is an old header, kept for programs that include it.
#include <FlatBodyFile.h>
#include <Haptics/Servo/ServoScene.h>
#include <ServoStep.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <thread>

int main(int argc, char** argv)
{
  palpate::FlatBodyFile file;
  const std::string fault = file.open(argc > 1 ? argv[1] : "");
  if (!fault.empty())
  {
    std::fprintf(stderr, "%s\n", fault.c_str());
    return 1;
  }
  const auto body = palpate::makeContactBody(file.body());
  palpate::ServoStep servo(*body, palpate::WorkspaceMapping(), 20.0);
  double strongest = 0.0;
  palpate::Tick last;
  auto deadline = std::chrono::steady_clock::now();
  for (int tick = 0; tick < 300; ++tick)
  {
    // From 2 mm above the top of the cylinder (radius 50 mm) to 1 mm below it, and back.
    const double time = 1e-3 * tick;
    palpate::DeviceSample sample;
    sample.valid = true;
    sample.position = { 0.0, 0.0, 0.052 - 0.003 * std::sin(3.14159265358979 * tick / 299.0) };
    last = servo.step(sample, time);
    strongest = std::max(strongest, last.deviceForce.norm());
    deadline += std::chrono::milliseconds(1);
    std::this_thread::sleep_until(deadline);
  }
  std::printf("strongest force %.4g N, last %.4g N\n", strongest, last.deviceForce.norm());
  // The exact sphere of 6.35 mm at 1 mm and E* = 3.45 MPa: 11.4088 N. The mesh is below the circle
  // of the cylinder.
  return std::abs(strongest - 11.4088) < 0.05 && last.deviceForce.norm() == 0.0 ? 0 : 1;
}
