// Stands for the headers that every test reads, compiled once (tests/CMakeLists.txt).
