# Kinegon for nixpkgs.
{
  lib,
  rustPlatform,
  fetchzip,
  installShellFiles,
}:

rustPlatform.buildRustPackage (finalAttrs: {
  pname = "kinegon";
  version = "@VERSION@";

  src = fetchzip {
    url = "@PLACE@/archive/refs/tags/v${finalAttrs.version}.tar.gz";
    # The first build names it.
    hash = lib.fakeHash;
  };

  cargoLock.lockFile = "${finalAttrs.src}/Cargo.lock";
  buildType = "dist";
  cargoBuildFlags = [
    "--bin"
    "kinegon"
  ];
  # The tests want Chromium, LaTeX and Poppler; the figure below is drawn instead.
  doCheck = false;

  nativeBuildInputs = [ installShellFiles ];

  postInstall = ''
    installShellCompletion --cmd kinegon \
      --bash <($out/bin/kinegon completions bash) \
      --zsh <($out/bin/kinegon completions zsh) \
      --fish <($out/bin/kinegon completions fish)
    $out/bin/kinegon man -o man/
    installManPage man/*.1
    install -Dm644 -t $out/share/licenses/kinegon LICENSE-MIT LICENSE-APACHE THIRD-PARTY.txt src/drawing/fonts/OFL-1.1.txt
  '';

  doInstallCheck = true;
  installCheckPhase = ''
    $out/bin/kinegon new paper-figure-2 | $out/bin/kinegon draw - -o figure.svg
    test -s figure.svg
  '';

  meta = {
    description = "Velocity and acceleration plans of planar mechanisms, drawn true to scale";
    homepage = "@PLACE@";
    license = with lib.licenses; [
      mit
      asl20
      ofl
    ];
    mainProgram = "kinegon";
  };
})
