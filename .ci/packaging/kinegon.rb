# Kinegon in a tap of Homebrew.
class Kinegon < Formula
  desc "Velocity and acceleration plans of planar mechanisms, drawn true to scale"
  homepage "@PLACE@"
  url "@PLACE@/archive/refs/tags/v@VERSION@.tar.gz"
  sha256 "@SHA256@"
  license all_of: [{ any_of: ["MIT", "Apache-2.0"] }, "OFL-1.1"]

  depends_on "rust" => :build

  def install
    system "cargo", "install", "--profile", "dist", *std_cargo_args
    generate_completions_from_executable(bin/"kinegon", "completions", shells: [:bash, :zsh, :fish, :pwsh])
    system bin/"kinegon", "man", "-o", "#{buildpath}/man/"
    man1.install Dir["man/*.1"]
    doc.install "THIRD-PARTY.txt", "src/drawing/fonts/OFL-1.1.txt"
  end

  test do
    system bin/"kinegon", "new", "paper-figure-2", "-o", "scene.json"
    system bin/"kinegon", "draw", "scene.json", "-o", "figure.svg"
    assert_path_exists testpath/"figure.svg"
  end
end
