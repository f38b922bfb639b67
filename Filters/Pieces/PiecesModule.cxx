// SPDX-License-Identifier: BSD-3-Clause
#include "Pieces/PieceProbe.h"
#include "Pieces/SeamSearch.h"

namespace palpate
{
namespace
{
std::shared_ptr<const BodyPiece> makePiece(vtkPolyData* body, const BodySeam& seam)
{
  return std::make_shared<const BodyPiece>(body, seam);
}

std::string touchPieces(const Ranks& ranks, const BodyPiece& piece, const std::string& responseName,
  const PressedTips& tips, std::vector<PieceTouch>& touched, std::string& defects)
{
  PieceProbe probe(ranks, piece, responseName);
  std::string fault = probe.touch(tips, touched);
  defects = probe.defects();
  return fault;
}
} // namespace
} // namespace palpate

/// The only symbol that the module exports.
extern "C" __attribute__((visibility("default"))) const palpate::ModuleTable* palpatePiecesModule()
{
  static const palpate::PiecesModule module{ { PALPATE_VERSION }, palpate::findSeam,
    palpate::makePiece, palpate::touchPieces };
  return &module;
}
