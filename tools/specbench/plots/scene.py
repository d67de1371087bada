"""What a scene needs: drawn in a later step."""


def draw(path, folder):
    pass
