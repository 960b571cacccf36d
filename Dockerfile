# One image for server and eyes. Headless pictures come from Mesa's software renderer; no GPU is needed.
FROM debian:bookworm-slim AS build
WORKDIR /src
COPY scripts/install_packages.sh scripts/
RUN scripts/install_packages.sh build && rm -rf /var/lib/apt/lists/*
COPY . .
RUN cmake --preset release -DCOHERENCY_TESTS=OFF -DCOHERENCY_BENCH=OFF \
 && cmake --build --preset release \
 && cmake --install build/release --prefix /opt/coherency --strip

FROM debian:bookworm-slim
RUN apt-get update \
 && apt-get install -y --no-install-recommends libegl1 libegl-mesa0 libepoxy0 libfmt9 libgl1-mesa-dri libglfw3 \
      libpng16-16 libprotobuf-lite32 libsodium23 libtomlplusplus3 libusb-1.0-0 python3 \
 && rm -rf /var/lib/apt/lists/*
COPY --from=build /opt/coherency /opt/coherency
ENV PATH=/opt/coherency/bin:$PATH
# Nothing here needs root.
RUN useradd --create-home coherency && mkdir /out && chown coherency /out
USER coherency
VOLUME /out
WORKDIR /out
EXPOSE 7430/tcp 7430/udp
CMD ["motion_server", "--config", "/opt/coherency/share/coherency/servers/lan.toml", "--insecure"]
