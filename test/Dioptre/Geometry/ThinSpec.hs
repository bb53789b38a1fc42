-- |
-- Module      : Dioptre.Geometry.ThinSpec
-- Description : Flat cones and caps: the laws
module Dioptre.Geometry.ThinSpec (spec) where

import Laws.Exactness (closestIsTheListsOwn)
import Laws.Thin
import Test.Hspec
import Test.Hspec.QuickCheck (modifyMaxSuccess, prop)
import Test.QuickCheck (forAllBlind)

spec :: Spec
spec = do
  describe "A cone or a cap, however flat," . modifyMaxSuccess (const 2000) $ do
    prop "is met within its rim" isMetWithin
    prop "is not met beside it" isNotMetBeside
    prop "is met next to its disk, and nowhere else" isMetNextToItsDisk
    prop "keeps its texture coordinates on the picture" isOnItsPicture
    prop "changes continuously where its rule does" changesContinuously
  describe "Many flat cones and caps" . modifyMaxSuccess (const 100) $
    prop "are met by the index as by the plain list" $ forAllBlind thinCrowd closestIsTheListsOwn
