// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_PromptReader_h
#define palpate_PromptReader_h

#include "vtkObjectFactory.h"
#include "vtkXMLDataParser.h"

#include <string>

namespace palpate
{
/**
 * A parser that makes expat parse all data before the binary part.
 *
 * VTK passes the tag <AppendedData> to expat in pieces and relies on an immediate callback. Since
 * version 2.6 (and in Debian's patched 2.5), expat defers the parsing of such pieces until the
 * input has doubled. VTK then continues into the binary data and fails (VTK issue 19258). Blanks
 * after the end of the document make expat parse the deferred pieces and have no other effect.
 */
class PromptParser : public vtkXMLDataParser
{
public:
  static PromptParser* New() { VTK_STANDARD_NEW_BODY(PromptParser); }
  vtkTypeMacro(PromptParser, vtkXMLDataParser);

protected:
  int ParseBuffer(const char* buffer, unsigned int count) override
  {
    static const std::string tag = "<AppendedData";
    static const std::string blanks(1 << 16, ' ');
    int ok = this->vtkXMLDataParser::ParseBuffer(buffer, count);
    const bool ended = this->AppendedDataMatched == static_cast<int>(tag.size());
    if (ok && ended && this->AppendedDataPosition == 0)
    {
      ok = this->vtkXMLParser::ParseBuffer(blanks.data(), static_cast<unsigned int>(blanks.size()));
    }
    return ok;
  }
};

/** A vtkXMLReader that parses with PromptParser. */
template <class Reader>
class PromptReader : public Reader
{
public:
  static PromptReader* New() { VTK_STANDARD_NEW_BODY(PromptReader); }

protected:
  void CreateXMLParser() override { this->XMLParser = PromptParser::New(); }
};
} // namespace palpate

#endif
