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

/// The own tips of a rank, which have passed checkTips.
struct PressedTips
{
  vtkPolyData* tips = nullptr;
  const ContactSettings& settings;
  double indentation = 0.0; ///< mm
  /// The kernel of one rank: presses the tips into a part of the body.
  std::function<void(const ContactBody& part, const TipVisitor& visit)> press;
};

/// What one of these tips touched.
struct PieceTouch
{
  Vector3 at = Vector3::Zero(); ///< where the tip was after the indentation
  Contact contact;              ///< its triangle: the cell of that rank's piece
  int rank = -1;                ///< that has the touched cell; -1: none
};

/**
 * What libpalpatePieces.so adds: what is only done where a body lies in pieces on several
 * processes. No library links the module; the first filter with more than one process loads it.
 * All functions but makePiece are collective.
 */
struct PiecesModule : ModuleTable
{
  BodySeam::Points (*findSeam)(const Ranks& ranks, vtkPolyData* body);
  /// `body`: the own piece, with the response to be touched, or empty.
  std::shared_ptr<const BodyPiece> (*makePiece)(vtkPolyData* body, const BodySeam& seam);
  /// The contacts of the own tips, and in `defects` what is wrong with the mesh around them. The
  /// same error on all ranks, or "".
  std::string (*touch)(const Ranks& ranks, const BodyPiece& piece, const std::string& responseName,
    const PressedTips& tips, std::vector<PieceTouch>& touched, std::string& defects);
};

/// The loaded module, or the reason why there is none, in words.
struct LoadedPieces
{
  const PiecesModule* module = nullptr;
  std::string fault; ///< empty if there is a module
};

/// Loads the module at the first call; later calls return the same. Any thread may call it.
const LoadedPieces& loadedPieces();

/// Why several ranks cannot share a body, naming the module that is missing; "" if they can, or if
/// there is one rank. To be asked before a BodySeam is made. Collective.
std::string missingPieces(const Ranks& ranks);
} // namespace palpate

#endif
