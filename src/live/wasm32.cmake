# CMake's toolchain file for WebAssembly: clang 14 with the C library of WASI (the preset `wasm` names it)
set(CMAKE_SYSTEM_NAME Generic)
set(CMAKE_SYSTEM_PROCESSOR wasm32)
set(CMAKE_CXX_COMPILER clang++-14)
set(CMAKE_CXX_COMPILER_TARGET wasm32-wasi)
# A program without a main is all that the compiler could be tried on
set(CMAKE_TRY_COMPILE_TARGET_TYPE STATIC_LIBRARY)
# The headers of Eigen and toml++ are the machine's own
set(CMAKE_SYSTEM_PREFIX_PATH /usr/local /usr)
