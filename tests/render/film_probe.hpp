#pragma once

#include <array>
#include <cstdio>
#include <filesystem>
#include <string>

namespace drape::render {

/// What ffprobe tells about a film: "width,height,rate,frames".
inline std::string probeFilm(const std::filesystem::path& film) {
  const std::string command =
      "ffprobe -v error -count_frames -select_streams v:0 -show_entries "
      "stream=width,height,r_frame_rate,nb_read_frames -of csv=p=0 '" +
      film.string() + "' 2>&1";
  std::string answer;
  FILE* pipe = popen(command.c_str(), "r");
  std::array<char, 256> buffer{};
  while (pipe != nullptr && std::fgets(buffer.data(), buffer.size(), pipe) != nullptr) {
    answer += buffer.data();
  }
  pclose(pipe);
  return answer.substr(0, answer.find_first_of("\r\n"));
}

}  // namespace drape::render
