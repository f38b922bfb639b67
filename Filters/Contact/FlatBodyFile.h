// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_FlatBodyFile_h
#define palpate_FlatBodyFile_h

#include "Contact/ContactBody.h"
#include "Mechanics/Files/MappedFile.h"
#include "Mechanics/PalpateExport.h"
#include "Contact/ResponseField.h"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>

namespace palpate
{
/// A body with one response, as views of flat arrays in mm and N.
struct FlatBody
{
  std::size_t points = 0;
  std::size_t triangles = 0;
  const double* coordinates = nullptr;   ///< 3 values per point
  const std::int32_t* corners = nullptr; ///< 3 per triangle, counter-clockwise as seen from outside
  ResponseArrays response;               ///< response at the same points
  const float* validity = nullptr;       ///< 1 value per point
  const std::uint8_t* limit = nullptr;   ///< 1 value per point
  std::string tool;                      ///< specification of the tool for parseTool()
  std::string model;
  int modelParts = 0; ///< sum of ModelPart
};

/**
 * A body file: a header, then the arrays of a FlatBody, each aligned to 64 bytes, in the byte order
 * of the machine. The file is mapped into memory instead of being read. It is used by servo loops
 * without VTK, and as a cache.
 *
 * Header (see FlatBodyHeader.h): magic "PALPATE", format version, byte-order mark, size of the
 * file, checksum of header and arrays, counts, and the start of each array. A file is refused with
 * a reason if it is truncated, damaged, of another kind or byte order, or of a newer format; no
 * file is loaded in part. Older formats can be read: format 1 has no model parts (they are derived
 * from the text of the model), format 2 no EdgeTerms, format 3 no RelaxationTerms, format 4 no
 * CouplingTerms and no tilts.
 */
class PALPATE_EXPORT FlatBodyFile
{
public:
  static constexpr std::uint32_t Version = 5;

  /// Writes a new file, then replaces an existing file by it, so that a failure leaves the existing
  /// file unchanged. Returns a message that names the file on failure, else "".
  static std::string write(const std::string& path, const FlatBody& body);

  /// Maps a file. On failure, returns a message with the name of the file and its fault; otherwise
  /// returns "".
  std::string open(const std::string& path);

  /// Returns the content of the file. Its pointers are valid until the next open() or the end of
  /// this object.
  const FlatBody& body() const noexcept { return this->Body; }

private:
  MappedFile File;
  FlatBody Body;
};

/// Creates a body for the servo tick from a copy of `body`. The memory of `body` may be freed
/// afterwards.
PALPATE_EXPORT std::shared_ptr<const ContactBody> makeContactBody(const FlatBody& body);
} // namespace palpate

#endif
