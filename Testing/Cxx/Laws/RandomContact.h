// SPDX-License-Identifier: BSD-3-Clause
#ifndef RandomContact_h
#define RandomContact_h

#include "Contact/ResponseContract.h"

#include <random>
#include <string>
#include <vector>

namespace palpate::testing
{
/// Families of random contacts.
enum class ContactFamily
{
  HalfSpace, ///< any tool on a flat half-space
  Layer,     ///< any tool on a bonded or slipping layer
  Stack,     ///< a sphere or cone on two or three layers
  Ball,      ///< any tool on a ball, pressed from two opposite sides
  Cavity     ///< any tool in a spherical cavity
};
constexpr const char* ContactFamilyNames[] = { "half-space", "layer", "stack", "ball", "cavity" };

/// A force of one law and the force of finite elements at finite strain (Neo-Hooke) in the same
/// contact.
struct JudgedForce
{
  std::string law; ///< "small", "curved", "finite", "curved finite"
  double depth;    ///< mm
  double radius;   ///< contact radius by the law of small strain on the flat body, mm
  double force;    ///< force of the law, N
  double exact;    ///< force of the finite elements, N
  double stated;   ///< estimated relative error of the law
  ResponseLimit limit;

  double error() const; ///< |exact/force - 1|
};

/// A random contact and its results.
struct RandomContact
{
  ContactFamily family;
  std::string tool;
  std::string body; ///< description of the body: ν, layers, radius
  std::vector<JudgedForce> forces;
  std::string fault; ///< reason why there are no forces; "": none
};

/// Relative error of the solver's force, from refinement: mesh (edges of 0.12 of the contact
/// radius) and far field.
constexpr double SolverError = 0.004;

/**
 * Draws a contact, computes the product's responses (each with its stated error) and solves the
 * same contact with finite elements. The exact force is the law of small strain on the flat body,
 * which has closed forms, times a factor from the solver for finite strain and the shape of the
 * body. The factor is the ratio of finite strain to linear strain on a flat body on the same mesh,
 * so that the error of the mesh and that of rounded corners cancel.
 * Lengths are relative to the tool, about 1 mm. Cost: 5 to 20 s of processor time.
 */
RandomContact drawContact(ContactFamily family, std::mt19937& random);

/// As drawContact, for a given sphere on a given ball (mm, MPa).
RandomContact pressOnBall(const std::string& tool, double deepest, double radius,
  double poissonRatio, double youngsModulus);
} // namespace palpate::testing

#endif
