#include "identity/sha1.h"

#include <doctest/doctest.h>

#include <string>

using specbake::internal::sha1;

TEST_CASE("SHA-1 of the messages of FIPS 180 and about the length of a block, as sha1sum tells") {
    CHECK(sha1("abc") == "A9993E364706816ABA3E25717850C26C9CD0D89D");
    CHECK(sha1("abcdbcdecdefdefgefghfghighijhijkijkljklmklmnlmnomnopnopq") ==
          "84983E441C3BD26EBAAE4AA1F95129E5E54670F1");
    CHECK(sha1("") == "DA39A3EE5E6B4B0D3255BFEF95601890AFD80709");
    CHECK(sha1(std::string(1'000'000, 'a')) == "34AA973CD4C4DAA4F61EEB2BDBAD27316534016F");
    CHECK(sha1(std::string(55, 'a')) == "C1C8BBDC22796E28C0E15163D20899B65621D65A");
    CHECK(sha1(std::string(64, 'a')) == "0098BA824B5C16427BD7A1122A5A442A25EC644D");
}
