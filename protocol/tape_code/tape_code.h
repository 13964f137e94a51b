// tape_code: the code of a character on tape or line. Here live framing and parity, end of block in its four forms, the
// characters that a control takes, and the two streaming converters between program text and wire bytes with their
// bookkeeping of places. Not here: when a byte may go out (protocol/feed), ports, clocks, files, and what a program
// means. This header brings all of the folder.
#pragma once

#include "protocol/tape_code/character_set.h"
#include "protocol/tape_code/eob.h"
#include "protocol/tape_code/framing.h"
#include "protocol/tape_code/parity.h"
#include "protocol/tape_code/text_source.h"
#include "protocol/tape_code/wire_decoder.h"
#include "protocol/tape_code/wire_encoder.h"
