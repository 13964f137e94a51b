"""Signing in at a real OpenID Connect provider, Glewlwyd of Debian, in a real browser: the rig of page.py with a provider next to the server. What the
browser test may ask for besides: the groups of a person at the provider, and its end."""

import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "api"))
from client import Client, in_folder, shop  # noqa: E402
from page import Shop, run  # noqa: E402
from provider import CLIENT, PLAIN_SECRET, Glewlwyd  # noqa: E402

PASSWORD = "the password of olga"


class ShopWithProvider(Shop):
    def __init__(self, folder):
        port = shop.free_port()
        page = f"http://127.0.0.1:{port}"
        self.provider = Glewlwyd(folder, f"{page}/sign-in")
        self.provider.add_user("olga", PASSWORD, ["dnc", "heads"])
        self.provider.add_user("carl", PASSWORD, ["tennis"])
        (folder / "secret").write_text(PLAIN_SECRET + "\n")
        client = Client(folder, "--oidc", self.provider.issuer, "--oidc-client-id", CLIENT, "--oidc-client-secret-file", str(folder / "secret"), "--oidc-page", page,
                        "--oidc-scope", "", "--oidc-title", "the shop's login", "--oidc-local", "--oidc-group", "dnc=operator", "--oidc-group", "heads=approver")
        client.server.given_port = port
        super().__init__(folder, client.start())

    def login(self):
        """A password that is right for all at the provider."""
        return {"password": PASSWORD}

    def set_groups(self, name, groups):
        self.provider.set_groups(name, groups)

    def provider_ends(self):
        self.provider.end()

    def close(self):
        super().close()
        self.provider.end()


if __name__ == "__main__":
    in_folder(lambda folder: run(folder, ShopWithProvider))
