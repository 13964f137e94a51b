// modbus: moving a program into a receiver block by block over holding registers ("block mailbox"), each block appended
// exactly once. Here live the register images, the sending and the receiving side, and a server of read-only registers
// with its TCP frames, without any I/O. Not here: the client's frames, sockets and serial ports (the driver has a
// library for them), clocks, the ledger. This header brings the folder. The mailbox begins at register 0, the answer to
// the doorbell at 121, the status at 128, the machine's words at 147 (server/app/ports/register_bus.h); all are holding
// registers.
//
// Mailbox H, written by the host. 16-bit registers; 32-bit values have the high word first.
//   0      magic DF01h
//   1-2    session, not 0, new for every job
//   3      command: 0 idle (takes back hold), 1 open, 2 data, 3 eof, 4 abort, 5 hold
//   4      seq 1..65535, 65535 is followed by 1
//   5      byte length n of the payload
//   6-7    CRC-32 over registers 0-5, 8-9 and the payload registers
//   8-9    offset of the payload in the text; for eof the length of the text
//   10..   payload, 2 characters a register, the first in the high byte, the last register filled with 0
//   next   seq again: the commit word, last of the write
// Status G, written by the receiver.
//   0      magic DF01h
//   1-2    session, echoed
//   3      state: 0 boot, 1 idle, 2 ready, 3 running, 4 held, 5 done, 6 error
//   4      seq of the last block appended, 0 before the first
//   5, 6   nak code (0 none, 1 crc, 2 sequence, 3 length, 4 offset, 5 conflict, 6 full, 7 closed), seq of it
//   7      free blocks (credit)
//   8-9    bytes taken by the interpreter
//   10     boot counter, 11 heartbeat, 12 reason of state error
//   13-14  bytes appended in this session
//   15-16  CRC-32 of these bytes
//   17-18  CRC-32 over registers 0-16, so that an image read while it is written is known as such
// Machine M, written by the receiver; may be left out. Read together with G where it is there.
//   0      magic DF03h
//   1      state: 0 not known, 1 idle, 2 running, 3 held, 4 alarm, 5 emergency stop, 6 manual
//   2-3    number of the program, 0 none
//   4-5    line of the text that is executed, from 1; 0 not known
//   6-7    the control's alarm number, 0 none
//   8      doorbell: counts the rings, 1..65535, 65535 is followed by 1; 0 none since the start
//   9      what is asked for: 1 load, 2 drip, 3 cancel, 4 call a person, 5 good parts, 6 scrap to count
//   10-11  program number asked for; of 5 and 6 how many parts
//   12-13  CRC-32 over registers 0-11
// Answer A, written by the host after a ring, past the mailbox.
//   0      the doorbell's count that is answered
//   1      1 answered, 2 armed, 3 queued (a person arms it), 4 refused
//   2      why it is refused: 1 not found, 2 released for drip only, 3 protected number, 4 not allowed by the
//          profile, 5 busy, 6 missed (it was not seen to come: ring again), 7 unknown request,
//          8 no order that takes parts
//   3-4    job number, 0 none
//   5-6    CRC-32 over registers 0-4
// Rules. The receiver takes a message only if magic, session, commit word and CRC fit; it appends seq = last + 1 and
// only then says so; the last seq again is a duplicate and changes nothing. The host has one block outstanding and
// after any error reads G: last = seq means done, last = seq - 1 means write the same block again, all else means stop
// and ask. A ring is registers 9-11 of M first, then 8 one higher, in one scan; the next one waits for the answer to
// this. The host acts on a ring once, and only if it saw the count before it with the same boot counter and not longer
// ago than 10 s; any other count that A does not answer yet is answered "missed". So neither a restart of either side
// nor a link that was away makes a ring count twice or late.
#pragma once

#include "protocol/modbus/doorbell.h"
#include "protocol/modbus/machine_words.h"
#include "protocol/modbus/mailbox.h"
#include "protocol/modbus/mbap.h"
#include "protocol/modbus/receiver.h"
#include "protocol/modbus/register_server.h"
#include "protocol/modbus/sender.h"
#include "protocol/modbus/sender_state.h"
