// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_LoadedPieces_h
#define palpate_LoadedPieces_h

#include "Contact/ContactSettings.h"
#include "Mechanics/Files/ModuleFile.h"
#include "Response/Pieces/BodySeam.h"
#include "Response/Touch/TipContacts.h"

#include <functional>
#include <memory>
#include <string>
#include <vector>

class vtkPolyData;

namespace palpate
{
class BodyPiece;
class ContactBody;

/// Tips of this rank that have passed checkTips, with their settings.
struct PressedTips
{
  vtkPolyData* tips = nullptr;
  const ContactSettings& settings;
  double indentation = 0.0; ///< distance by which each tip is first moved inward, mm
  /// Presses the tips into a part of the body with the kernel for a single rank.
  std::function<void(const ContactBody& part, const TipVisitor& visit)> press;
};

/// The contact of one tip of PressedTips.
struct PieceTouch
{
  Vector3 at = Vector3::Zero(); ///< position of the tip after the indentation
  Contact contact;              ///< the contact; its triangle is a cell of the piece of `rank`
  int rank = -1;                ///< rank that has the touched cell; -1 without contact
};

/**
 * Functions of libpalpatePieces.so. These functions are needed only if a body is divided among
 * several processes. No library links the module. The first filter that runs on more than one
 * process loads it. All functions except makePiece are collective.
 */
struct PiecesModule : ModuleTable
{
  BodySeam::Points (*findSeam)(const Ranks& ranks, vtkPolyData* body);
  /// Creates the piece of this rank. `body` is this rank's piece with the response, or empty.
  std::shared_ptr<const BodyPiece> (*makePiece)(vtkPolyData* body, const BodySeam& seam);
  /// Computes the contacts of this rank's tips. `defects` receives a description of the defects of
  /// the mesh around the tips. Returns "" or an error message, the same on all ranks.
  std::string (*touch)(const Ranks& ranks, const BodyPiece& piece, const std::string& responseName,
    const PressedTips& tips, std::vector<PieceTouch>& touched, std::string& defects);
};

/// The loaded module, or the reason why it could not be loaded.
struct LoadedPieces
{
  const PiecesModule* module = nullptr;
  std::string fault; ///< reason why the module is missing; empty if the module is loaded
};

/// Loads the module at the first call. Later calls return the same result. Any thread may call the
/// function.
const LoadedPieces& loadedPieces();

/// Returns the reason why several ranks cannot share a body, with the name of the missing module.
/// Returns "" if the module is loaded, or if there is only one rank. Call the function before a
/// BodySeam is constructed. Collective.
std::string missingPieces(const Ranks& ranks);
} // namespace palpate

#endif
