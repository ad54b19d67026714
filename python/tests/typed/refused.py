"""A user's program with slips. Type checkers refuse each line that says so, and no other."""

import kinegon
from kinegon.types import SceneFile

scene = kinegon.Scene.kind("four-bar")
solution = scene.solve()

solution.draw(lanuage="es")  # refused
solution.draw(language="esp")  # refused
solution.draw(style="papr")  # refused
solution.draw("bmp")  # refused
solution.draw(notation="french")  # refused
solution.draw(sliding="point")  # refused
solution.draw(frame=0)  # refused
solution.draw(turnd="clockwise")  # refused
solution.draw(page="a5")  # refused
solution.draw(panels=["speed"])  # refused
solution.draw("png", dpi="200")  # refused
solution.save("figure.svg", layer=True)  # refused
solution.save("figure.svg", style="lectur")  # refused
solution.interactive(hight=3)  # refused
scene.draw(sheets=2)  # refused
scene.with_figure(style="own.json")  # refused
scene.exercise(seed=7, langage="es")  # refused
scene.exercise(seed=7).sheet("html")  # refused
scene.exercise(seed=7).form("xml")  # refused
solution.check({"omega(3)": 1}).draw("gif")  # refused

text: str = solution.draw("png")  # refused
data: bytes = solution.draw()  # refused
rate = solution.result()["links"]["3"]["omga"]  # refused
place: str = solution.result()["points"]["C"]["on_link"]  # refused
allowed = scene.exercise(seed=7).key()["value"]  # refused
done = solution.check({"omega(3)": 1}).result["diagnosis"]["mistake"]  # refused
unit: int = solution.quantity("omega(3)").unit  # refused

file: SceneFile = {"kinegon": 1, "unit": {"length": "mm", "time": "s"}, "links": {}}  # refused
