// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_testing_CBall_h
#define palpate_testing_CBall_h

#include "Haptics/palpate.h"

#include "Contact/FlatBodyFile.h"
#include "SampleResponses.h"
#include "ScratchFile.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <memory>
#include <vector>

namespace palpate::testing
{
using BodyHandle = std::unique_ptr<palpate_body, decltype(&palpate_body_free)>;
using ContactHandle = std::unique_ptr<palpate_contact, decltype(&palpate_contact_free)>;
using SceneHandle = std::unique_ptr<palpate_scene, decltype(&palpate_scene_free)>;

/// A ball for C and the same ball for C++, with F = `factor` 10 δ^1.5 N.
struct CBall
{
  BodyHandle c{ nullptr, &palpate_body_free };
  std::shared_ptr<const ContactBody> kernel;

  explicit CBall(float factor)
  {
    const Surface ball = icosphere(20.0, 3);
    ResponseStore store(ball.points.size());
    store.normalsFromPoints(ball);
    for (std::vector<float>* values : { &store.force, &store.stiffness })
    {
      std::for_each(values->begin(), values->end(), [factor](float& value) { value *= factor; });
    }
    const std::vector<float> validity(ball.points.size(), 1.0F);
    const std::vector<std::uint8_t> limit(ball.points.size(), 0);
    FlatBody body;
    body.points = ball.points.size();
    body.triangles = ball.triangles.size();
    body.coordinates = ball.points.front().data();
    body.corners = ball.triangles.front().data();
    body.response = store.arrays();
    body.validity = validity.data();
    body.limit = limit.data();
    const ScratchFile scratch(".palpate");
    EXPECT_EQ(FlatBodyFile::write(scratch.path(), body), "");
    this->c.reset(palpate_body_load(scratch.path().c_str(), nullptr, 0));
    this->kernel = contactBody(ball, store);
  }
};
} // namespace palpate::testing

#endif
