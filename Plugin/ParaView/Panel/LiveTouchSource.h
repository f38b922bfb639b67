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
/// A response of a body; the client knows these properties without the data.
struct StoredResponse
{
  std::string name; ///< prefix of the response arrays
  std::string tool; ///< tool of the response, for example "sphere:6.35"; "" if unknown
};

/// The part of the pipeline that is used for a live touch.
struct LiveTouchSource
{
  pqOutputPort* body = nullptr;      ///< the output with the body; null: see obstacle
  pqPipelineSource* touch = nullptr; ///< the source *Touch* whose handle defines the tip, or null
  std::vector<StoredResponse> responses;
  QString obstacle; ///< the reason as text why no live touch is possible; "" if it is possible
};

/// Finds the body of the active source. This is the output of the source or, for a source *Touch*,
/// its input, since its output is dented.
LiveTouchSource findLiveTouchSource(pqOutputPort* active);

/// Gets the data of the body to the client; waits for the server. With several ranks of the server
/// all parts are joined. Returns null, and an error, if there are no data.
vtkSmartPointer<vtkPolyData> fetchBody(pqOutputPort* body, QString& error);

/// Reads the handle of a source *Touch*, also during a drag that is not applied yet.
TouchHandle readTouchHandle(pqPipelineSource* touch);
} // namespace palpate

#endif
