// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_LiveTouchSource_h
#define palpate_LiveTouchSource_h

#include "LiveTouchPlace.h"

#include "vtkSmartPointer.h"

#include <QString>

#include <string>
#include <vector>

class pqOutputPort;
class pqPipelineSource;
class vtkPolyData;

namespace palpate
{
/// A response of a body. The client knows these properties without fetching the data.
struct StoredResponse
{
  std::string name; ///< prefix of the response arrays
  std::string tool; ///< tool of the response, such as "sphere:6.35"; "" if unknown
};

/// The part of the pipeline that is used for a live touch.
struct LiveTouchSource
{
  /// The output with the body; if null, `obstacle` contains the reason.
  pqOutputPort* body = nullptr;
  pqPipelineSource* touch = nullptr; ///< the source *Touch* whose handle defines the tip, or null
  std::vector<StoredResponse> responses;
  QString obstacle; ///< reason why no live touch is possible; "" if it is possible
};

/// Finds the body for the active source. The body is the output of the source. For a source *Touch*
/// the body is its input, because its output is dented.
LiveTouchSource findLiveTouchSource(pqOutputPort* active);

/// Fetches the data of the body to the client and waits for the server. If the server has several
/// ranks, their parts are joined. If there are no data, returns null and sets `error`.
vtkSmartPointer<vtkPolyData> fetchBody(pqOutputPort* body, QString& error);

/// Reads the handle of a source *Touch*, including a drag that is not applied yet.
TouchHandle readTouchHandle(pqPipelineSource* touch);
} // namespace palpate

#endif
