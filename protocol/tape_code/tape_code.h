// tape_code: the code of a character on tape or line. Here live framing and parity, ASCII, ISO 840 and EIA RS-244, the
// end of block in its forms, the characters that a control takes, the two streaming converters between program text and
// wire bytes with their bookkeeping of places, and the finding out of a stream's code. Not here: when a byte may go out
// (protocol/feed), ports, clocks, files, and what a program means. This header brings all of the folder.
#pragma once

#include "protocol/tape_code/auto_decoder.h"
#include "protocol/tape_code/character_set.h"
#include "protocol/tape_code/code_table.h"
#include "protocol/tape_code/eia.h"
#include "protocol/tape_code/eob.h"
#include "protocol/tape_code/framing.h"
#include "protocol/tape_code/parity.h"
#include "protocol/tape_code/text_source.h"
#include "protocol/tape_code/wire_decoder.h"
#include "protocol/tape_code/wire_encoder.h"
