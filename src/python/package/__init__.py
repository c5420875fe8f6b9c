from . import _wristwise
from ._wristwise import *  # noqa: F403
from ._wristwise import __doc__ as __doc__, __version__ as __version__

__all__ = [name for name in vars(_wristwise) if not name.startswith("_")]

del _wristwise
