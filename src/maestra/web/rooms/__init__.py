"""Rooms: where patients play, several at once, with boards, robots and who looks on."""
