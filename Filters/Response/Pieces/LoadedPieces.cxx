// SPDX-License-Identifier: BSD-3-Clause
#include "Response/Pieces/LoadedPieces.h"

#include "Mechanics/JoinedText.h"

namespace palpate
{
namespace
{
LoadedPieces load()
{
  const LoadedModule loaded = loadModule("palpatePieces");
  return { static_cast<const PiecesModule*>(loaded.table), loaded.fault };
}
} // namespace

const LoadedPieces& loadedPieces()
{
  static const LoadedPieces pieces = load();
  return pieces;
}

std::string missingPieces(const Ranks& ranks)
{
  if (ranks.areAlone())
  {
    return {};
  }
  const std::string& fault = loadedPieces().fault;
  return ranks.firstFault(fault.empty()
      ? fault
      : joined("a body on ", ranks.count(), " processes needs ", missingModule("Pieces", fault)));
}
} // namespace palpate
