// A sweep on many ranks as a discrete-event simulation of mc/hand_out: ranks compute, report and
// wait; rank 0 looks at its messages, answers them one after another, and builds study.h5 now and
// then and at the end.
#pragma once

#include <array>
#include <cstdint>

namespace cagetol {

/// All in seconds.
struct HandOutCosts {
  double message_s = 0;       ///< rank 0's time for a report and its answer
  double record_s = 0;        ///< a sample in the journal of its rank
  double journal_s = 0;       ///< a journal made; one after another in one folder
  double file_sample_s = 0;   ///< study.h5, for each sample ...
  double file_journal_s = 0;  ///< ... and each journal
  double latency_s = 50e-6;   ///< of a message on its way
};

struct HandOutPrediction {
  struct Loss {
    const char* name;
    double share = 0;  ///< of all ranks' time
  };
  double efficiency = 0;  ///< time inside samples / (ranks * time from start to end)
  std::array<Loss, 5> losses{
      {{"start"}, {"waiting for answers"}, {"journal"}, {"last samples"}, {"study.h5"}}};
  double server_busy = 0;  ///< share of time that rank 0 answers

  const Loss& largest_loss() const;
};

/// `samples_per_rank` samples for each of `ranks`, of `sample_s` in the mean, scattering by 30 %.
HandOutPrediction predict_hand_out(int ranks, double sample_s, std::uint64_t samples_per_rank,
                                   const HandOutCosts& costs);

}  // namespace cagetol
