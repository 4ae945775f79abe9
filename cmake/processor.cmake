# The processors that pmr is built for. The pair kernels and their bits are written for AVX2 and FMA
# (x86-64-v3: Intel from Haswell of 2013, AMD from Excavator of 2015 on).
if(NOT CMAKE_SYSTEM_PROCESSOR MATCHES "^(x86_64|amd64|AMD64)$")
  message(FATAL_ERROR
    "pmr cannot be built for ${CMAKE_SYSTEM_PROCESSOR}: its kernels need x86-64 with AVX2 and FMA "
    "(Intel from Haswell, AMD from Excavator on; AVX-512 is used where it is found). "
    "What works: such a machine, or an emulator of one (qemu-x86_64 -cpu max).")
endif()
if(NOT CMAKE_CROSSCOMPILING AND EXISTS /proc/cpuinfo)
  file(STRINGS /proc/cpuinfo pmr_flags REGEX "^flags" LIMIT_COUNT 1)
  foreach(flag avx2 fma bmi2)
    if(pmr_flags AND NOT pmr_flags MATCHES " ${flag}( |$)")
      message(WARNING
        "This processor lacks ${flag}. pmr builds here, but stops at its start with a message; it "
        "runs on x86-64 with AVX2 and FMA (Intel from Haswell, AMD from Excavator on).")
      break()
    endif()
  endforeach()
endif()
