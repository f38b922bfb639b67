// SPDX-License-Identifier: BSD-3-Clause
#ifndef RandomContact_h
#define RandomContact_h

#include "Contact/ResponseContract.h"

#include <random>
#include <string>
#include <vector>

namespace palpate::testing
{
/// What contacts are drawn of.
enum class ContactFamily
{
  HalfSpace, ///< any tool on a flat half-space
  Layer,     ///< on a bonded or slipping layer
  Stack,     ///< a sphere or cone on two or three layers
  Ball,      ///< on a ball, from two opposite sides
  Cavity     ///< in a spherical cavity
};
constexpr const char* ContactFamilyNames[] = { "half-space", "layer", "stack", "ball", "cavity" };

/// One force of a law beside that of finite elements at finite strain (Neo-Hooke).
struct JudgedForce
{
  std::string law; ///< "small", "curved", "finite", "curved finite"
  double depth;    ///< mm
  double radius;   ///< of the contact, by the plain law, mm
  double force;    ///< of the law, N
  double exact;    ///< N
  double stated;   ///< its estimated relative error
  ResponseLimit limit;

  double error() const; ///< |exact/force - 1|
};

/// A contact drawn at random, and how it came out.
struct RandomContact
{
  ContactFamily family;
  std::string tool;
  std::string body; ///< in words: ν, layers, radius
  std::vector<JudgedForce> forces;
  std::string fault; ///< why there are fewer
};

/// What the solver's own force may be off, relative: mesh (edges of 0.12 of the contact radius) and
/// the far field, by refinement.
constexpr double SolverError = 0.004;

/**
 * Draws a contact, lets the product make its responses (each with its stated error) and solves the
 * same with finite elements. Exact is the law of small strain on the flat body, which has closed
 * forms, times what the solver says of finite strain and of the body's shape: finite over linear
 * and flat, on the same mesh, so that its error and that of rounded corners cancel.
 *
 * Lengths are of the tool, about 1 mm. Cost: 5 to 20 s of a processor.
 */
RandomContact drawContact(ContactFamily family, std::mt19937& random);

/// The same of a sphere that is given, on a ball (mm, MPa).
RandomContact pressOnBall(const std::string& tool, double deepest, double radius,
  double poissonsRatio, double youngsModulus);
} // namespace palpate::testing

#endif
