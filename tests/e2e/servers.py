"""The page where two servers share a store on PostgreSQL: it is opened at server b. The test asks this rig for what happens at server a."""

import sys

import page
from client import HandControl, hand_profile, in_folder
from nodes import Node
from postgresql import Database


class Servers(page.Shop):
    """Server a has the lathe, server b the mill."""

    def __init__(self, folder):
        self.database = Database()
        self.a = Node(folder, self.database.add("servers"), "a")
        self.lathe = HandControl()
        self.a.post("/machines", hand_profile(self.lathe))
        super().__init__(folder, Node(folder, self.a.store[-1], "b", self.a))
        self.machine("mill", jobs=0)

    def lines_of_a(self):
        return [machine["name"] for machine in self.a.nodes()["a"]["machines"]]

    def tear_at_a(self):
        """Server a feeds the lathe and is gone inside a block. Answers the job."""
        release = self.a.release(self.a.add_program(3000, "O0777")["id"])["id"]
        job = self.a.queue(release)
        self.a.wait_line("lathe", "idle")
        self.a.post(f"/jobs/{job}/arm")
        self.lathe.say(page.DC1)
        self.lathe.wait_bytes(600)
        self.lathe.hold_inside_block()
        self.a.server.kill()
        return job

    def close(self):
        super().close()
        if self.a.server.alive():
            self.a.server.stop()
        self.database.end()


if __name__ == "__main__":
    in_folder(lambda folder: page.run(folder, Servers))
