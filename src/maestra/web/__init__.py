"""The web app: pages for caregivers and for patients, and the stream that board and robot join."""
